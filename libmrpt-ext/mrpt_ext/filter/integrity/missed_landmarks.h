#pragma once

#include <cstddef>
#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// What it tells about a pose hypothesis that landmarks in view have no detection, where detections are anonymous.
///
/// A wrong pose was selected because what is detected fits it. What it expects beside that is not there: of the
/// landmarks in view of a wrong pose half may be missed, of the right one those that something hides. The number of
/// detections does not show it, since clutter fills the gaps.
///
/// Under the pose hypothesis a landmark in view is missed with probability 1 - P c (detection probability, visibility);
/// under the null hypothesis nothing is expected there. What hides a landmark goes on to hide it: its P has a beta
/// distribution (Bernardo & Smith, Bayesian Theory, 1994, section 5.2) with the declared detection probability as its
/// mean, worth one reading, and at most that mean.
///
/// Only landmarks that were not seen so far count. One that was is a feature that the null model tracks and expects to
/// be seen again: that it is missed surprises both hypotheses alike.
///
/// That a landmark is seen counts by the density of the detection alone. Its probability P would be one more factor,
/// but so would the expected number of detections be for the null hypothesis; they nearly cancel, and to leave out both
/// is on the safe side.
class MissedLandmarks
{
 public:
  /// `draws` from the particles stand for all of them.
  explicit MissedLandmarks(std::size_t landmarks, std::size_t draws = 64) : draws_(draws), histories_(landmarks) {}

  /// Another pose hypothesis.
  void clear() { histories_.assign(histories_.size(), {}); }
  /// Log-likelihood ratio of the misses of a reading, at most 0, over normalised particles; counts the reading. A
  /// detection probability that is not declared is taken for a half.
  [[nodiscard]] double count(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles);
  /// Share of the readings with the landmark in view that show it, with a uniform prior.
  [[nodiscard]] double shareSeen(std::size_t landmark) const
  {
    const History& history = histories_[landmark];
    return (1 + history.seen) / (2 + history.seen + history.missed);
  }

 private:
  /// Expected number of readings with the landmark in view.
  struct History
  {
    double seen = 0, missed = 0;
  };

  std::size_t draws_;
  std::vector<History> histories_;  // by landmark
};
}  // namespace mrpt_ext
