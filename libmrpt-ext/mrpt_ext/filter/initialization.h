#pragma once

#include <span>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/hypotheses/proposal_distribution.h"

namespace mrpt_ext
{
/// What a filter is given when it needs to know where the robot may be.
struct Proposal
{
  Proposal() = default;
  Proposal(HypothesisSet set) : hypotheses(std::move(set)) {}  // NOLINT(google-explicit-constructor)

  HypothesisSet hypotheses;
  /// Readings of the last seconds seen from the newest frame, the newest included: the evidence to start on. Empty:
  /// that of the frame alone.
  std::vector<Reading> joined_readings;
  /// False while more readings will be joined: a start without hypotheses, or, without names, one that does not single
  /// out a place, is better put off.
  bool complete = true;
};

/// `count` poses drawn from the mixture and weighted (log prior - log density) against the uniform prior over the
/// region; draws outside the region are drawn again. Not normalised. They share the origin of `like`, and its
/// systematic errors, which are drawn too.
[[nodiscard]] ParticleSet sampleSeeds(const ProposalDistribution& mixture, const PoseRegion& region, std::size_t count,
                                      RandomStream& random, const ParticleSet& like = {});

/// Every hypothesis with its own spread and again with `wide_std` (x, y [m], phi [rad]) added: a seed that is as sharp
/// as its measurements finds a sharp likelihood, a wide one forgives a solver that is too sure.
[[nodiscard]] HypothesisSet withWideCopies(const HypothesisSet& hypotheses, const Vector3d& wide_std);

/// Largest exponent in (0, 1] such that the samples weighted with likelihood^exponent still count for `effective` ones
/// (annealed importance sampling: Neal, Stat. Comput. 11(2), 2001). `log_prior`: log weights before the likelihood,
/// `log_weight`: with it.
[[nodiscard]] double annealingExponent(std::span<const float> log_prior, std::span<const float> log_weight,
                                       double effective);

/// The modes of a first sample as hypotheses, for a second and better one (population Monte Carlo: Cappe et al., J.
/// Comput. Graph. Stat. 13(4), 2004). Lighter modes than a ten-thousandth are left to the uniform share.
[[nodiscard]] HypothesisSet hypothesesFrom(const ModeSet& modes);
}  // namespace mrpt_ext
