#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/feature_null_model.h"
#include "mrpt_ext/filter/integrity/independent_detections.h"
#include "mrpt_ext/filter/integrity/landmark_evidence.h"
#include "mrpt_ext/filter/integrity/missed_landmarks.h"
#include "mrpt_ext/filter/integrity/seen_landmarks.h"
#include "mrpt_ext/filter/integrity/slip_test.h"
#include "mrpt_ext/filter/integrity/spot_evidence.h"
#include "mrpt_ext/filter/integrity/stray_detections.h"
#include "mrpt_ext/filter/integrity/symmetric_rivals.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// Sequential probability ratio test (Wald, Ann. Math. Stat. 16(2), 1945) of "the robot is where its particles are"
/// against the null hypothesis "the measurements fit there by chance".
///
/// A filter whose particles missed the right pose converges to the best wrong one, and nearly all detections are
/// inliers there: it was selected for that. The detections it was selected by are no evidence, nor are correlated ones.
/// So only independent detections count (independent_detections.h), with their likelihood under the particles *before*
/// they are weighted. Each adds its log-likelihood ratio against the null model (feature_null_model.h). Under the null
/// hypothesis the odds exceed 1/a with probability a at most, at any time (Ville's inequality); at the right pose they
/// grow with every independent detection. Detections that repeat themselves at one spot neither prove nor refute
/// (spot_evidence.h). Landmarks that the pose expects and nothing shows count as well, where detections are anonymous
/// (missed_landmarks.h), and what is seen and not in the map is expected the more, the more of it there was
/// (stray_detections.h).
///
/// Beside chance there are the rivals of landmark_evidence.h, which fit one landmark as well. Against those one
/// landmark alone proves nothing, however often it is seen; once the pose is verified they are refuted, and each
/// landmark counts, until nothing is left of the odds. Where a compass measures the heading there are none, nor where a
/// landmark is seen to face its direction (facing_likelihood.h).
///
/// And there are the rivals of symmetric_rivals.h, from which the map looks the same: the odds are the least of both.
class SequentialPoseTest
{
 public:
  static constexpr double kAcceptLogOdds = 9;   ///< one wrong pose in exp(9) = 8000 gets that far
  static constexpr double kRejectLogOdds = -5;  ///< at which the robot is searched elsewhere
  static constexpr double kMaxLogOdds = 14;     ///< remembered at most, so that a later error shows soon
  /// After a gap without detections longer than kDecayAfter [s] the robot may have slipped, and anonymous detections
  /// fit wrong poses too. Each second beyond takes kDecayPerS from positive log odds; for identified ones see endGap().
  static constexpr double kDecayPerS = 0.3, kDecayAfter = 5;

  SequentialPoseTest(const MotionModel& motion, const LandmarkTable& map);

  /// The start: `samples` of the uniform prior with log weights log(prior / density), not yet weighted with `readings`.
  /// The best of many poses is never verified by that alone: rooms look alike.
  void start(const std::vector<Reading>& readings, const LandmarkTable& map, const ParticleSet& samples);
  /// Scores the frame's independent detections by the particles moved to it and not yet weighted with it (normalised).
  void update(const Frame& frame, const LandmarkTable& map, const ParticleSet& predicted);
  /// True when the robot may have slipped since the last detection, at the end of the motion.
  [[nodiscard]] bool isGap(const OdometryMotion& motion) const { return gap_ + motion.duration > kDecayAfter; }
  /// Identified detections end a gap with the next frame. What was known before holds unless the robot slipped, and to
  /// which pose only the landmarks from here on tell.
  void endGap(const OdometryMotion& motion);
  /// Remembers the frame's detections without counting them: the mode is selected by them.
  void skip(const Frame& frame);
  /// Another mode is under test.
  void reset()
  {
    doubt();
    log_odds_ = 0;
  }
  /// The detections do not agree with the mode, and hypotheses compete with it. For the one that survives, what was
  /// known before counts as much as a start at most, and nothing counts against it.
  void doubt()
  {
    log_odds_ = std::clamp(log_odds_, 0.0, kAcceptLogOdds / 2);
    slip_.clear();
    seen_.clear();
    strays_.clear();
    missed_.clear();
    by_landmark_.restart(false);
    symmetric_.doubt();
    rivals_refuted_ = heading_seen_ = false;
  }
  /// The pose is known.
  void accept()
  {
    log_odds_ = kMaxLogOdds;
    slip_.clear();
    symmetric_.accept();
  }
  /// Odometry alone has moved the pose for so many seconds, and most of its variance is odometry's.
  void suspectSlip(double seconds) { slip_.suspect(seconds); }
  [[nodiscard]] bool slipRefuted() const { return slip_.refuted(); }
  [[nodiscard]] SymmetricRivals& rivals() { return symmetric_; }

  [[nodiscard]] double logOdds() const { return std::min(log_odds_, symmetric_.logOdds()); }
  [[nodiscard]] bool verified() const { return logOdds() >= kAcceptLogOdds; }
  [[nodiscard]] bool refuted() const { return logOdds() <= kRejectLogOdds; }
  /// Log odds against the null hypothesis alone.
  [[nodiscard]] double logOddsAgainstChance() const { return log_odds_; }
  /// Motion to the rival by symmetry that alone keeps the pose from being verified.
  [[nodiscard]] std::optional<Pose2> rival() const
  {
    return log_odds_ >= kAcceptLogOdds && !verified() ? symmetric_.strongest() : std::nullopt;
  }

 private:
  void move(const OdometryMotion& motion);
  /// Where detections return after a gap, and none of them is identified: earlier evidence counts less.
  void decayAfterGap(const Frame& frame);
  /// The null models follow detections that do not count.
  void track(const Reading& correlated);
  /// Adds the log-likelihood ratio of the readings' independent detections; `particles` are weighted with them.
  void test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles);
  /// What SpotEvidence knows of a reading.
  struct Spot
  {
    bool first;           ///< of the sensor
    double share_of_new;  ///< of its detections
  };
  /// Adds the log-likelihood ratio of the only detection of a reading; `particles` are weighted with it.
  void testDetection(const Reading& part, const LandmarkTable& map, ParticleSet& particles, const Spot& spot);
  /// What counts of the log-likelihood ratio of a single detection of `landmark`.
  [[nodiscard]] double counted(const Reading& part, std::optional<std::size_t> landmark, double log_ratio,
                               const Spot& spot);

  DetectionDecorrelator decorrelator_;
  FeatureNullModel null_model_;
  SlipTest slip_;
  SeenLandmarks seen_;
  std::map<std::string, StrayDetections> strays_;  // by sensorKey()
  MissedLandmarks missed_;
  SpotEvidence spot_;
  LandmarkEvidence by_landmark_{kMaxLogOdds};
  SymmetricRivals symmetric_;
  bool rivals_refuted_ = false, heading_measured_ = false;
  bool heading_seen_ = false;  // by a landmark's direction, since the mode is under test
  double log_odds_ = 0;
  double gap_ = 0;  // [s] since the last detection
};
}  // namespace mrpt_ext
