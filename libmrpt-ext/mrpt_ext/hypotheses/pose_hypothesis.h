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
  double log_score = 0;       ///< log-likelihood of the measurements that support it
  double weight = 0;          ///< share of the total, in [0, 1]
  std::string source;         ///< solver or "particles"
  bool heading_known = true;  ///< false: any heading fits (ranges alone), the heading of `pose` means nothing
};

using HypothesisSet = std::vector<PoseHypothesis>;  ///< best first

/// Sorts best first by log_score and sets the weights to the normalised likelihoods.
void rankByScore(HypothesisSet& hypotheses);

/// Joins hypotheses closer than `distance` [m] and `angle` [rad] (heading ignored where unknown), keeping the better.
void mergeDuplicates(HypothesisSet& hypotheses, double distance, double angle);
}  // namespace mrpt_ext
