#pragma once

#include <cmath>
#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/hypotheses/mixture_density.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// Proposal distribution of importance sampling (Probabilistic Robotics, section 4.3.3): a share of the uniform
/// distribution over the region plus one Gaussian per hypothesis (uniform heading where it is unknown). The uniform
/// share keeps every pose possible. As the density is known, samples can be weighted by target / proposal.
class ProposalDistribution
{
 public:
  /// Covariances are multiplied by `inflation` (above 1: a proposal should be wider than its target), and the variances
  /// `min_std`^2 (x, y [m], phi [rad]) are added, in case a solver is overconfident.
  ProposalDistribution(const HypothesisSet& hypotheses, const PoseRegion& region, double uniform_share,
                       double inflation, const Vector3d& min_std);

  [[nodiscard]] Pose2 sample(RandomStream& random) const;
  /// Density [1/(m^2 rad)] at a pose.
  [[nodiscard]] double density(const Pose2& pose) const;
  /// The same for many poses, in single precision. Poses next to each other should be close together (ordered by
  /// place): then few components are within reach of a block of them.
  [[nodiscard]] std::vector<float> densities(const PoseBatch& poses) const;
  /// Components, on average, whose support reaches the mean of one: what the density of a sample costs.
  [[nodiscard]] double overlap() const;

 private:
  struct Component
  {
    Pose2 mean;
    Matrix3d cholesky;     // lower factor of the covariance
    Matrix3d information;  // inverse covariance
    double log_norm = 0;
    double cumulative = 0;  // of the component weights
    double share = 0;
    double half_phi = 0;  // [rad] of its support, as in SupportBox
    bool heading_known = true;
  };
  /// Box outside of which the density of a component counts as zero: most components are far from most poses.
  struct SupportBox
  {
    double x = 0, y = 0, half_x = 0, half_y = 0;  // [m]
    [[nodiscard]] bool contains(double at_x, double at_y) const
    {
      return std::abs(at_x - x) <= half_x && std::abs(at_y - y) <= half_y;
    }
  };
  [[nodiscard]] MixtureTerm termOf(std::size_t component, const Vector2d& origin) const;

  std::vector<Component> components_;
  std::vector<SupportBox> support_;  // of each component
  PoseRegion region_;
  double uniform_share_;
};
}  // namespace mrpt_ext
