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
///
/// A pose that was predicted over a gap was not found by the landmarks that end it: the first detection of each is
/// evidence against every rival, and only those after it are as above.
class LandmarkEvidence
{
 public:
  /// `most`: log-likelihood ratio of one landmark at most.
  explicit LandmarkEvidence(double most) : most_(most) {}

  /// `predicted`: no landmark that is seen from here on has found the pose.
  void restart(bool predicted)
  {
    by_landmark_.clear();
    predicted_ = predicted;
  }
  /// Adds the log-likelihood ratio of a detection of the landmark; returns by how much the evidence changes.
  double add(std::size_t landmark, double log_ratio)
  {
    const auto [entry, is_first] = by_landmark_.try_emplace(landmark, 0.0);
    if (is_first && predicted_) return log_ratio;
    double& own = entry->second;
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
  bool predicted_ = false;
  std::map<std::size_t, double> by_landmark_;
};
}  // namespace mrpt_ext
