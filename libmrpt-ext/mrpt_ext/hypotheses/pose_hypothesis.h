#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// A pose that the robot may have, with its likelihood and the solver that proposed it.
struct PoseHypothesis
{
  GaussianPose pose;
  double log_score = 0;       ///< log-likelihood of the measurements that support it
  double weight = 0;          ///< normalised likelihood, in [0, 1]
  std::string source;         ///< name of the solver, or "particles"
  bool heading_known = true;  ///< false: uniform heading (ranges only); the heading of `pose` is meaningless
};

using HypothesisSet = std::vector<PoseHypothesis>;  ///< best first

/// Sorts by log_score, best first, and sets the weights to the normalised likelihoods.
void rankByScore(HypothesisSet& hypotheses);

/// Merges hypotheses closer than `distance` [m] and `angle` [rad], keeping the better one. Hypotheses of unknown
/// heading merge among themselves only.
void mergeDuplicates(HypothesisSet& hypotheses, double distance, double angle);
}  // namespace mrpt_ext
