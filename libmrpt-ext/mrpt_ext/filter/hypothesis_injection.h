#pragma once

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
/// Weight below which a place gets no particles.
inline constexpr double kLeastPlaceShare = 0.002;

/// Weight of the places that are not the one which is `held`. `along_way`: places weighted by what was seen along the
/// way behind; the rest of the weight is elsewhere.
[[nodiscard]] double weightElsewhere(const HypothesisSet& along_way, const Pose2& held);

/// Share of the posterior that belongs to the places of the way, in [0, 1), when those that are not held have the
/// weight `others`. Their odds are not trusted beyond ten to one however sure the way says to be: of the poses that
/// searches along MRCLAM's ways by bearings call 99.9 % sure, one in ten is wrong (errors that go on for a while are no
/// independent witnesses). What fresh looks have told for the held place since it was taken up, `log_odds_held`, counts
/// for it.
[[nodiscard]] double injectedShare(double others, double log_odds_held);

/// Gives `share` of the weight of normalised particles to those places, `count` particles each; places below
/// kLeastPlaceShare get none. Their systematic errors are drawn anew.
void injectHypotheses(ParticleSet& particles, const HypothesisSet& along_way, double share, std::size_t count,
                      RandomStream& random);
}  // namespace mrpt_ext
