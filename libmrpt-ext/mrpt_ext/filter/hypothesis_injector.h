#pragma once

#include "mrpt_ext/filter/integrity/recovery_options.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// A hypothesis with less weight gets no particles.
inline constexpr double kMinInjectedWeight = 0.002;

/// Adds particles for pose hypotheses that compete with the posterior. The weighted set then represents
/// (1 - prior) * posterior + prior * p(elsewhere): a wrong hypothesis costs particles but no accuracy.
class HypothesisInjector
{
 public:
  /// `region`: all poses that a relocalization considers. `particles`: their number while there is one mode.
  HypothesisInjector(const RecoveryOptions& options, const PoseRegion& region, std::size_t particles)
      : options_(options), region_(region), particles_(particles)
  {
  }

  /// Number of particles that inject() adds.
  [[nodiscard]] std::size_t count() const;
  /// Draws particles from a mixture of the proposed hypotheses, the slipped modes and the uniform distribution over the
  /// region. Their importance weights refer to p(elsewhere): slipped modes and uniform distribution. `prior`:
  /// probability that the robot is elsewhere.
  void inject(ParticleSet& particles, HypothesisSet proposed, const HypothesisSet& slipped, double prior,
              RandomStream& random) const;
  /// The modes with the covariance that a wheel slip leaves; empty if RecoveryOptions::slip_share is 0.
  [[nodiscard]] HypothesisSet withSlip(HypothesisSet modes) const;
  /// Gives `share` of the weight of normalised particles to the hypotheses of a trajectory search, in proportion to
  /// their weights; those below kMinInjectedWeight get none. Systematic errors are drawn from their prior.
  void injectTrajectory(ParticleSet& particles, const HypothesisSet& trajectory, double share,
                        RandomStream& random) const;

 private:
  RecoveryOptions options_;
  PoseRegion region_;
  std::size_t particles_;
};

/// Total weight of those hypotheses of a trajectory search that are not near the `best` mode. All weights together may
/// be less than 1: the rest belongs to no hypothesis.
[[nodiscard]] double weightElsewhere(const HypothesisSet& trajectory, const Pose2& best);

/// Share of the posterior, in [0, 1), for the hypotheses of a trajectory search; those not near the best mode have the
/// weight `elsewhere`. Their odds are limited to ten to one: on MRCLAM, one in ten poses with a weight of 99.9 % from a
/// search by bearings is wrong, because errors are correlated along a trajectory. The `log_odds` of the best mode
/// (SequentialPoseTest) count against them.
[[nodiscard]] double injectedShare(double elsewhere, double log_odds);
}  // namespace mrpt_ext
