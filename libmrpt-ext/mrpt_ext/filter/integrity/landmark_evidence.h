#pragma once

#include <algorithm>
#include <cstddef>
#include <map>

namespace mrpt_ext
{
/// Evidence for a pose against all rivals that fit one landmark as well as it does.
///
/// Poses that see one landmark at the same range and bearing lie on a circle around it, and the motion carries that
/// circle along rigidly: however often the landmark is seen again, none of them is refuted. A pose that was found by
/// one landmark and a false detection is one of these, so the landmark's detections say nothing for it. The
/// log-likelihood ratio against the composite null hypothesis "wrong, but right about some landmark" is the least one,
/// that is the sum over all landmarks but the one with most.
class LandmarkEvidence
{
 public:
  /// `most`: log-likelihood ratio of one landmark at most.
  explicit LandmarkEvidence(double most) : most_(most) {}

  void clear() { by_landmark_.clear(); }
  /// Adds the log-likelihood ratio of a detection of the landmark; returns by how much the evidence changes.
  double add(std::size_t landmark, double log_ratio)
  {
    double& own = by_landmark_[landmark];
    const double before = own - leading();
    own = std::min(own + log_ratio, most_);
    return own - leading() - before;
  }

 private:
  [[nodiscard]] double leading() const
  {
    double most = 0;
    for (const auto& [landmark, log_ratio] : by_landmark_) most = std::max(most, log_ratio);
    return most;
  }

  double most_;
  std::map<std::size_t, double> by_landmark_;
};
}  // namespace mrpt_ext
