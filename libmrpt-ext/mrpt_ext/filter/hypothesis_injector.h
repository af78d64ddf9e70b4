#pragma once

#include "mrpt_ext/filter/integrity/recovery_options.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// Weight below which a hypothesis gets no particles.
inline constexpr double kMinInjectedWeight = 0.002;

/// Adds particles for hypotheses that compete with the posterior, weighted so that the set represents
/// (1 - prior) * posterior + prior * p(elsewhere): a wrong hypothesis costs particles, no accuracy.
class HypothesisInjector
{
 public:
  /// `region`: where the robot can be found again. `particles`: of a filter with one mode.
  HypothesisInjector(const RecoveryOptions& options, const PoseRegion& region, std::size_t particles)
      : options_(options), region_(region), particles_(particles)
  {
  }

  /// Number of particles of one injection.
  [[nodiscard]] std::size_t count() const;
  /// Injects draws from a mixture of the proposed hypotheses, the slipped modes and the region; importance weights
  /// against p(elsewhere), which is the slipped modes and the uniform distribution over the region.
  void inject(ParticleSet& particles, HypothesisSet proposed, const HypothesisSet& slipped, double prior,
              RandomStream& random) const;
  /// The modes, as uncertain as they are after a slip of odometry; empty if those are switched off.
  [[nodiscard]] HypothesisSet withSlip(HypothesisSet modes) const;
  /// Gives `share` of the weight of normalised particles to hypotheses of the trajectory, in proportion to their
  /// weights; those below kMinInjectedWeight get none. Systematic errors are drawn from their prior.
  void injectTrajectory(ParticleSet& particles, const HypothesisSet& trajectory, double share,
                        RandomStream& random) const;

 private:
  RecoveryOptions options_;
  PoseRegion region_;
  std::size_t particles_;
};

/// Weight of the hypotheses of a trajectory that are not at the pose of the `best` mode; what is missing to 1 is
/// unknown.
[[nodiscard]] double weightElsewhere(const HypothesisSet& trajectory, const Pose2& best);

/// Share of the posterior that the hypotheses of a trajectory get, in [0, 1), when those elsewhere have the weight
/// `elsewhere`. Their odds are limited to ten to one: of the poses that trajectory searches by bearings give 99.9 % on
/// MRCLAM, one in ten is wrong (errors are correlated along a trajectory). `log_odds`: evidence for the best mode since
/// it has been under test; it counts against them.
[[nodiscard]] double injectedShare(double elsewhere, double log_odds);
}  // namespace mrpt_ext
