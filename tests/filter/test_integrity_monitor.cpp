#include "mrpt_ext/filter/integrity_monitor.h"

#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext::test_integrity_monitor
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {1, 1, 0}}, {.id = 2, .position = {9, 2, 0}}});

IntegrityMonitor monitorOf() { return {{}, {}, motionModelOf({}), {}, kMap}; }

/// A precise best mode, and if it is not all, another one far away.
ModeSet modesAt(const Pose2& pose, double weight = 1, double std = 0.05)
{
  const Matrix3d covariance = square(std) * Matrix3d::Identity();
  ModeSet modes{{{{pose, covariance}, weight}}, {}};
  if (weight < 1) modes.modes.push_back({{{9, 9, 2}, covariance}, 1 - weight});
  return modes;
}

InlierReport report(double inliers, std::size_t detections, const std::string& sensor = "camera bearings")
{
  const double expected = 0.95 * static_cast<double>(detections);
  return {{sensor, inliers, expected, expected, detections}};
}

/// A detection of landmark `id` after moving ahead; without: nothing is seen.
Frame afterMoving(double distance, std::optional<int> id = std::nullopt)
{
  Frame frame{.motion = {.increment = {distance, 0, 0}, .path_length = distance, .duration = 1}};
  if (id) frame.readings.push_back({.detections = {{.id = *id, .bearing = 0}}});
  return frame;
}
}  // namespace

TEST(IntegrityMonitor, AKnownStartIsOkUntilTheInlierRatioFalls)
{
  IntegrityMonitor monitor = monitorOf();
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::ambiguous) << "not verified";
  monitor.startVerified({});
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::ok);
  for (int k = 0; k < 10; ++k) monitor.update(report(3, 3));
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::ok);
  EXPECT_FALSE(monitor.relocalizationDue());
  monitor.update(report(0, 3));
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::ambiguous) << "the immediate ratio";
  EXPECT_FALSE(monitor.suspicious());
  for (int k = 0; k < 20; ++k) monitor.update(report(0, 3));
  EXPECT_TRUE(monitor.suspicious());
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::lost);
  EXPECT_NE(monitor.finding().find("camera bearings"), std::string::npos);
}

TEST(IntegrityMonitor, ClutterAtTheEndOfABlindSpellIsNotOk)
{
  IntegrityMonitor monitor = monitorOf();
  monitor.startVerified({});
  ModeSet modes = modesAt({});
  for (int k = 0; k < 20; ++k) monitor.update(report(1, 1), modes);
  modes.modes.front().pose.covariance *= square(2.5);
  EXPECT_EQ(monitor.verdict(modes, 1e4).verdict, Verdict::ok) << "nothing is seen";
  monitor.update(report(0, 1), modes);
  EXPECT_EQ(monitor.verdict(modes, 1e4).verdict, Verdict::ambiguous);
  monitor.update(report(1, 1), modes);
  EXPECT_EQ(monitor.verdict(modes, 1e4).verdict, Verdict::ok);
}

TEST(IntegrityMonitor, ThatAnAnonymousDetectionFitsAtTheEndOfABlindSpellIsNoProof)
{
  const auto verdict_after = [](int id, double seconds)
  {
    const MotionModel motion{.std_xy_per_m = 0.1, .std_phi_per_deg = 0, .std_phi_per_m = degToRad(0.5)};
    IntegrityMonitor monitor({}, {}, motion, {}, kMap);
    monitor.startVerified({});
    (void)monitor.followMode(modesAt({1, 1, 0}), afterMoving(0, id));
    monitor.update(report(1, 1), modesAt({1, 1, 0}));
    Frame later = afterMoving(4, id);
    later.motion.duration = seconds;
    monitor.test(later, {}, false);
    monitor.update(report(1, 1), modesAt({5, 1, 0}));
    return monitor.verdict(modesAt({5, 1, 0}), 1e4);
  };
  const VerdictWithReason anonymous = verdict_after(kNoId, 8);
  EXPECT_EQ(anonymous.verdict, Verdict::ambiguous);
  EXPECT_NE(anonymous.reason.find("odometry alone led here"), std::string::npos) << anonymous.reason;
  EXPECT_EQ(verdict_after(kNoId, 1).verdict, Verdict::ok) << "a short one";
  EXPECT_EQ(verdict_after(1, 8).verdict, Verdict::ok) << "identified";
}

TEST(IntegrityMonitor, FewInliersOfOneSensorMakeRelocalizationDue)
{
  IntegrityMonitor monitor = monitorOf();
  const auto both = [&](double camera_inliers)
  {
    InlierReport all = report(19, 20, "radio ranges");
    all.push_back(report(camera_inliers, 1).front());
    monitor.update(all);
  };
  for (int k = 0; k < 60; ++k) both(1);
  EXPECT_FALSE(monitor.relocalizationDue());
  for (int k = 0; k < 12; ++k) both(0);
  EXPECT_FALSE(monitor.suspicious());
  EXPECT_TRUE(monitor.relocalizationDue());
}

TEST(IntegrityMonitor, ContradictionByTheTrajectoryWithholdsOk)
{
  IntegrityMonitor monitor = monitorOf();
  monitor.startVerified({});
  monitor.setContradicted(true);
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::ambiguous);
  monitor.setContradicted(false);
  EXPECT_EQ(monitor.verdict(modesAt({}), 1e4).verdict, Verdict::ok);
}

TEST(IntegrityMonitor, TheLogOddsStayWithTheirModeAsItMoves)
{
  IntegrityMonitor monitor = monitorOf();
  monitor.startVerified({});
  EXPECT_FALSE(monitor.followMode(modesAt({1, 1, 0}), afterMoving(0, 1)));
  EXPECT_FALSE(monitor.followMode(modesAt({2, 1, 0}), afterMoving(1, 1))) << "it moved as odometry did";
  EXPECT_TRUE(monitor.verified());
  EXPECT_FALSE(monitor.followMode(modesAt({5, 5, 0}, 0.45), afterMoving(0, 1))) << "a rival without the majority";
  EXPECT_TRUE(monitor.verified());
  EXPECT_TRUE(monitor.followMode(modesAt({5, 5, 0}), afterMoving(0, 1))) << "another mode";
  EXPECT_FALSE(monitor.verified());
}

TEST(IntegrityMonitor, AGapEndsWithAnIdentifiedLandmarkWhileTheHeadingIsKnown)
{
  const MotionModel motion{.std_xy_per_m = 0.1, .std_phi_per_deg = 0, .std_phi_per_m = degToRad(0.5)};
  IntegrityMonitor monitor({}, {}, motion, {}, kMap);
  monitor.startVerified({});
  EXPECT_FALSE(monitor.endsGap(afterMoving(20, 1))) << "no mode yet";
  (void)monitor.followMode(modesAt({1, 1, 0}), afterMoving(0, 1));
  EXPECT_TRUE(monitor.endsGap(afterMoving(20, 1)));
  EXPECT_FALSE(monitor.endsGap(afterMoving(2, 1))) << "still precise";
  EXPECT_FALSE(monitor.endsGap(afterMoving(2000, 1))) << "nor is the heading known any more";
  EXPECT_FALSE(monitor.endsGap(afterMoving(20, kNoId)));
  Frame late = afterMoving(2, 1);
  late.motion.duration = SequentialPoseTest::kDecayAfter + 1;
  EXPECT_TRUE(monitor.endsGap(late)) << "precise, but it may have slipped";

  EXPECT_FALSE(monitor.followMode(modesAt({11, 1, 0}, 1, 2), afterMoving(10))) << "nothing was seen";
  EXPECT_TRUE(monitor.endsGap(afterMoving(10, 1)));
  monitor.test(afterMoving(10, 1), {}, true);
  EXPECT_LT(monitor.logOdds(), SequentialPoseTest::kMaxLogOdds);
  EXPECT_FALSE(monitor.followMode(modesAt({22, 1, 0}), afterMoving(10, 1))) << "1 m is within the prediction";
}

TEST(IntegrityMonitor, WithoutAModeUnderTestNothingIsVerified)
{
  IntegrityMonitor monitor = monitorOf();
  monitor.startVerified({});
  EXPECT_FALSE(monitor.followMode({}, afterMoving(0, 1))) << "no modes at all";
  EXPECT_TRUE(monitor.followMode(modesAt({}, 1, 2), afterMoving(0, 1))) << "too imprecise";
  EXPECT_FALSE(monitor.verified());
}

TEST(IntegrityMonitor, AFrameThatSelectedTheModeIsNoEvidence)
{
  RandomStream random(1);
  const Pose2 truth{4, 3, 0.5};
  ParticleSet particles({5, 5});
  for (int i = 0; i < 200; ++i)
    particles.add({truth.x + 0.03 * random.gaussian(), truth.y + 0.03 * random.gaussian(), truth.phi}, -std::log(200));
  const Frame frame = simulatedFrame({.measures_range = true}, kMap, truth, {}, random);
  IntegrityMonitor counting = monitorOf(), skipping = monitorOf();
  counting.test(frame, particles, true);
  skipping.test(frame, particles, false);
  EXPECT_GT(counting.logOdds(), 1);
  EXPECT_EQ(skipping.logOdds(), 0);
}
}  // namespace mrpt_ext::test_integrity_monitor
