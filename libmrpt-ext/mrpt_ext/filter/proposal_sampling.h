#pragma once

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/hypotheses/proposal_distribution.h"

namespace mrpt_ext
{
/// Distribution to draw particles from: a share of the uniform distribution over the region, and the hypotheses, each
/// wider than it claims to be and once more with kMinSeedStd added (withWideCopies).
[[nodiscard]] ProposalDistribution proposalAround(const HypothesisSet& hypotheses, const PoseRegion& region,
                                                  double uniform_share);

/// Every hypothesis with its own covariance and again with `wide_std` (x, y [m], phi [rad]) added: a seed as precise as
/// its measurements finds a narrow likelihood, a wide one tolerates an overconfident solver.
[[nodiscard]] HypothesisSet withWideCopies(const HypothesisSet& hypotheses, const Vector3d& wide_std);

/// `count` poses drawn from the distribution and weighted (log prior - log density) against the uniform prior over the
/// region; draws outside the region are drawn again. Not normalised. They share the origin of `like`, and its
/// systematic errors, which are drawn too.
[[nodiscard]] ParticleSet sampleSeeds(const ProposalDistribution& proposal, const PoseRegion& region, std::size_t count,
                                      RandomStream& random, const ParticleSet& like = {});

/// The modes of a sample as hypotheses, for a second and better one (population Monte Carlo: Cappe et al., J. Comput.
/// Graph. Stat. 13(4), 2004). Modes lighter than a ten-thousandth are left to the uniform share.
[[nodiscard]] HypothesisSet hypothesesFrom(const ModeSet& modes);
}  // namespace mrpt_ext
