#pragma once

#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// Distribution that hypothesis seeds are drawn from: a share of the uniform distribution over the region plus one
/// Gaussian per hypothesis (heading uniform where the hypothesis does not know it). The uniform share keeps every place
/// possible; with the density known, seeds can be weighted exactly (importance sampling) instead of counted as truth.
class ProposalDistribution
{
 public:
  /// Covariances are multiplied by `inflation` (above 1: a proposal should be wider than what it proposes for) and get
  /// the floor `min_std` (x, y [m], phi [rad]), so that a far too confident solver cannot hide the truth.
  ProposalDistribution(const HypothesisSet& hypotheses, const PoseRegion& region, double uniform_share,
                       double inflation, const Vector3d& min_std);

  [[nodiscard]] Pose2 sample(RandomStream& random) const;
  /// Density [1/(m^2 rad)] at a pose.
  [[nodiscard]] double density(const Pose2& pose) const;
  [[nodiscard]] std::size_t components() const { return components_.size(); }

 private:
  struct Component
  {
    Pose2 mean;
    Matrix3d cholesky;     // lower factor of the covariance
    Matrix3d information;  // inverse covariance
    double log_norm = 0;
    double cumulative = 0;  // of the component weights
    double share = 0;
    bool heading_known = true;
  };
  /// Box beyond which a component's density counts as zero, by itself: most of them are far from most poses.
  struct Reach
  {
    double x = 0, y = 0, half_x = 0, half_y = 0;  // [m]
  };
  std::vector<Component> components_;
  std::vector<Reach> reach_;  // of each component
  PoseRegion region_;
  double uniform_share_;
};
}  // namespace mrpt_ext
