#pragma once

#include <vector>

#include "mrpt_ext/filter/integrity/independent_detections.h"
#include "mrpt_ext/filter/integrity/null_model.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// When fresh looks have singled a place out.
struct SequentialPoseTestOptions
{
  double proven = 9;   ///< log odds against chance: one wrong place in exp(9) = 8000 gets that far
  double refuted = 5;  ///< log odds for chance, at which the robot is sought elsewhere
  double most = 14;    ///< log odds that are remembered at most, so that a wrong turn is felt soon
  /// A robot that saw nothing for a while may have slipped, or turned more than it knows, and what it sees then without
  /// names fits wrong places too. Each second beyond `decay_after` [s] takes this much of what spoke for its place.
  double decay_per_s = 0.3, decay_after = 5;
  DecorrelationOptions looks;  ///< what makes a look fresh
};

/// A sequential test (Wald, Ann. Math. Stat. 16(2), 1945) of "the robot is where its particles are" against "the
/// readings fit there by chance".
///
/// A filter whose particles missed the right place settles at the best wrong one and finds that it explains nearly all:
/// it was chosen for that. What it was chosen by proves nothing, nor does the same landmark seen again and again from
/// one spot. So only fresh looks count: detections of something not seen in that direction before, or seen again after
/// a piece of way, scored by the particles as they were *before*. Each adds the logarithm of its density over that of a
/// false detection. Where readings fit by chance alone, the odds exceed 1/a with probability a at most, whenever one
/// looks (Ville's inequality); at the right place they grow with every look.
class SequentialPoseTest
{
 public:
  SequentialPoseTest(const SequentialPoseTestOptions& options, const MotionModel& motion, const LandmarkTable& map);

  /// The start: `samples` of the uniform prior with log weights log(prior / density), not yet weighted with `readings`.
  /// The best of many places, it is never proven by that alone: maps are not made by chance, rooms look alike.
  void begin(const std::vector<Reading>& readings, const LandmarkTable& map, const ParticleSet& samples);
  /// Scores the frame's fresh looks by the particles moved to it and not yet weighted with it (normalised).
  void observe(const Frame& frame, const LandmarkTable& map, const ParticleSet& moved_particles);
  /// Remembers the frame's looks without counting them: the place is chosen by them.
  void note(const Frame& frame);
  /// Another place: nothing speaks for it yet.
  void restart() { log_odds_ = 0; }
  /// The place is known.
  void assume() { log_odds_ = options_.most; }

  [[nodiscard]] double logOdds() const { return log_odds_; }
  [[nodiscard]] bool proven() const { return log_odds_ >= options_.proven; }
  [[nodiscard]] bool refuted() const { return log_odds_ <= -options_.refuted; }

 private:
  void move(const OdometryMotion& motion);
  /// Where the frame shows something again, and nothing of it has a name: what was proven before counts less, the
  /// longer ago that is.
  void decayAfterGap(const Frame& frame);
  /// Logarithm of the density that fresh looks have without a map; remembers them.
  double logChance(const Reading& looks, double default_max_range);
  /// Adds to the log odds what the fresh looks among the readings tell; `particles` are weighted with them.
  void test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles);

  SequentialPoseTestOptions options_;
  DetectionDecorrelator looks_;
  NullModel mapless_;
  double log_odds_ = 0;
  double blind_for_ = 0;  // [s] since the last detection
};
}  // namespace mrpt_ext
