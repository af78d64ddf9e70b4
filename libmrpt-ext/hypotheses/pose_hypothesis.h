#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// One place where the robot may be, and who proposed it.
struct PoseHypothesis
{
  GaussianPose pose;
  double log_score = 0;  ///< log-likelihood of the measurements that support it
  double weight = 0;     ///< share of the total, in [0, 1]
  std::string source;    ///< solver or "particles"
};

using HypothesisSet = std::vector<PoseHypothesis>;  ///< best first
}  // namespace mrpt_ext
