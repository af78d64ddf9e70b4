#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/files/atomic_file.h"

namespace mrpt_ext
{
/// Writes objects.csv: `t,label,x,y,cxx,cxy,cyy,x_robot,y_robot`, detected objects that are no landmarks, in the
/// map frame with covariance [m^2] and in the robot frame [m].
void objectsCsv(const DiskBackedSequence<ObjectRow>& objects, const TextSink& write);
}  // namespace mrpt_ext
