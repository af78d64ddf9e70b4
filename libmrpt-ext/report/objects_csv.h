#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Text of objects.csv: `t,label,x,y,cxx,cxy,cyy,x_robot,y_robot`, seen things that are not landmarks, in the map
/// frame with covariance [m^2] and in the robot frame [m].
[[nodiscard]] std::string objectsCsv(const std::vector<ObjectRow>& objects);
}  // namespace mrpt_ext
