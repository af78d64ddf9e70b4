#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/filter/integrity/inlier_report.h"
#include "mrpt_ext/filter/integrity/pose_support.h"
#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/filter/integrity/sequential_pose_test.h"
#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/filter/motion/dead_reckoning.h"

namespace mrpt_ext
{
/// Judges the best mode without ground truth. The verdict combines the inlier ratios (fast, slow, immediate, per
/// sensor), the sequential test of the mode against the null hypothesis, and contradiction by the recent trajectory.
class IntegrityMonitor
{
 public:
  IntegrityMonitor(const RecoveryOptions& recovery, const VerdictOptions& verdict, const MotionModel& motion,
                   const BiasModel& biases, const LandmarkTable& map);

  /// The filter was initialized somewhere in `region`; for the other arguments see SequentialPoseTest::start().
  void start(const Frame& measurements, const ParticleSet& samples, const PoseRegion& region);
  /// The filter was initialized at a known pose: the mode is verified.
  /// `start`: where it was said to be, if its image under a symmetry of the map may be meant as well.
  void startVerified(const Frame& frame, const std::optional<GaussianPose>& start = std::nullopt);
  /// True when identified landmarks end a gap, a long one or one in which the position of the mode under test became
  /// imprecise, but not its heading: the frame can tell whether the mode is right. A heading that nothing supports is
  /// found anew.
  [[nodiscard]] bool endsGap(const Frame& frame) const;
  /// Tests the mode with a frame. `predicted`: normalised particles after the motion, not yet weighted with the frame.
  /// `counts` is false when the frame selects between modes or injected hypotheses: it is no evidence for the winner.
  void test(const Frame& frame, const ParticleSet& predicted, bool counts);
  /// Hypotheses from elsewhere compete because the detections do not agree: whatever wins has to be verified.
  void doubt();
  /// `contradicted`: the result of the trajectory search fits another pose better than the best mode.
  void setContradicted(bool contradicted) { contradicted_ = contradicted; }
  /// Predicts the mode under test by the odometry of the frame that was weighted. When another mode has most of the
  /// weight, or the mode under test is not precise any more, the test starts again and the result is true. A second
  /// mode that only appears for a while leaves the log odds as they are, and so does a frame without detections.
  bool followMode(const ModeSet& modes, const Frame& frame);
  /// Follows the mode of a known start, which is under test whatever it looks like.
  void followKnown(const ModeSet& modes, const Frame& frame);
  /// Updates the inlier ratios with the inliers of the weighted particles. `stated`: their modes, as judged.
  void update(const InlierReport& report, const ModeSet& stated = {});

  [[nodiscard]] bool verified() const { return pose_test_.verified(); }
  [[nodiscard]] double logOdds() const { return pose_test_.logOdds(); }
  /// The fast inlier ratio is below RecoveryOptions::reseed_inlier_ratio.
  [[nodiscard]] bool suspicious() const { return fast_ratio_.suspicious(); }
  /// True if the inlier ratio is low, in total or for one sensor, or the test has refuted the mode.
  [[nodiscard]] bool relocalizationDue() const
  {
    return suspicious() || sensor_ratios_.dropped() || pose_test_.refuted();
  }
  /// Recent inlier ratio relative to the expected one.
  [[nodiscard]] double inlierRatio() const { return fast_ratio_.average(); }
  /// `effective`: number of effective particles.
  [[nodiscard]] VerdictWithReason verdict(const ModeSet& modes, double effective) const;
  /// SensorMonitors::finding()
  [[nodiscard]] std::string finding() const { return sensor_ratios_.finding(); }

 private:
  /// Moves what is followed by odometry.
  void predictModes(const OdometryMotion& motion);
  void rememberVerified(const KalmanState& mode);
  /// Finds the odds against the rivals anew where a mode is the first one, or another one than before.
  void changeRivals(const GaussianPose& now, const Frame& frame);
  /// Whether `best` is another mode than the one under test. What moves a mode within its prediction is a correction if
  /// landmarks are identified; anonymous ones may have chosen another place.
  [[nodiscard]] bool hasLeft(const Mode& best, bool identified) const;

  VerdictOptions options_;
  MotionModel motion_;
  BiasModel biases_;
  LandmarkTable map_;
  InlierRatioMonitor fast_ratio_, slow_ratio_, immediate_ratio_;  // fast: against the learned clutter of the landmarks
  SensorMonitors sensor_ratios_;
  SequentialPoseTest pose_test_;
  PoseSupport support_;
  // Predicted by odometry: the mode under test, the last one that was verified, a given start until a mode is precise.
  std::optional<KalmanState> tested_mode_, verified_mode_, start_;
  std::optional<PoseRegion> start_region_;  // until a mode is verified
  DeadReckoning since_start_;
  bool at_start_ = false;    // the motion of the frame led there
  bool rivals_due_ = false;  // the next precise mode may be another one
  bool gap_ends_ = false;    // with the frame under test
  bool contradicted_ = false;
};
}  // namespace mrpt_ext
