#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/filter/integrity/inlier_report.h"
#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/filter/integrity/sequential_pose_test.h"
#include "mrpt_ext/filter/kalman/kalman_state.h"

namespace mrpt_ext
{
/// Does the best mode deserve trust? Combines the inlier ratios (fast, slow, immediate, per sensor), the sequential
/// test of the mode against the null hypothesis, and contradiction by the recent trajectory, and gives the verdict.
class IntegrityMonitor
{
 public:
  IntegrityMonitor(const RecoveryOptions& recovery, const VerdictOptions& verdict, const MotionModel& motion,
                   const BiasModel& biases, const LandmarkTable& map);

  /// Initialized globally with these measurements: SequentialPoseTest::start().
  void start(const Frame& measurements, const ParticleSet& samples);
  /// Initialized at a known pose: it is verified.
  void startVerified(const Frame& frame);
  /// Tests the mode on a frame, before the particles (moved to it, normalised) are weighted with it. Without `counts`
  /// the frame is only remembered: several modes, or injected hypotheses, are selected by it.
  void test(const Frame& frame, const ParticleSet& predicted, bool counts);
  /// Takes the trajectory's hypotheses: they may contradict the mode.
  void setContradicted(bool contradicted) { contradicted_ = contradicted; }
  /// Follows the mode under test by odometry. The test starts anew, and true is returned, when another mode has most of
  /// the weight or the mode under test is not precise any more. A rival that comes and goes takes nothing from the
  /// evidence so far.
  bool followMode(const ModeSet& modes, const OdometryMotion& motion);
  /// Takes the inliers of the updated posterior.
  void update(const InlierReport& report);

  [[nodiscard]] bool verified() const { return pose_test_.verified(); }
  [[nodiscard]] double logOdds() const { return pose_test_.logOdds(); }
  /// Too few inliers.
  [[nodiscard]] bool suspicious() const { return fast_ratio_.suspicious(); }
  /// Too few inliers, in total or of one sensor, or refuted by the test: search elsewhere.
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
  [[nodiscard]] bool hasLeft(const Mode& best) const;

  VerdictOptions options_;
  MotionModel motion_;
  BiasModel biases_;
  LandmarkTable map_;
  InlierRatioMonitor fast_ratio_, slow_ratio_, immediate_ratio_;  // fast: against the learned clutter of the landmarks
  SensorMonitors sensor_ratios_;
  SequentialPoseTest pose_test_;
  std::optional<KalmanState> tested_mode_;  // what pose_test_ is about
  bool contradicted_ = false;
};
}  // namespace mrpt_ext
