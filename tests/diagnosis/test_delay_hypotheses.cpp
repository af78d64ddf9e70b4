#include "mrpt_ext/diagnosis/delay_hypotheses.h"

#include <gtest/gtest.h>

#include "recorded_drive.h"

namespace mrpt_ext::test_delay_hypotheses
{
namespace
{
using testing::DrivePlan;

std::optional<DelayFinding> delayOf(const DrivePlan& plan, std::uint64_t seed)
{
  RandomStream random(seed);
  const CalibrationProblem problem = testing::recordedDrive(plan, random);
  const OdometryPath odometry(problem.odometry, {});
  // Odometry is declared three times as noisy as it is: that must not matter.
  const MotionModel motion{.std_xy_per_s = 3 * plan.std_distance_per_root_s,
                           .std_phi_per_s = 3 * plan.std_turn_per_root_s};
  DelayHypotheses delays(odometry, motion);
  delays.start({driveAt(plan, 0), Matrix3d::Identity() * 0.01}, problem.poses.front().time);
  std::size_t next = 0;
  for (std::size_t k = 0; k < problem.poses.size(); ++k)
  {
    if (k > 0) delays.predict(problem.poses[k].time);
    for (; next < problem.readings.size() && problem.readings[next].pose == k; ++next)
    {
      const CalibrationReading& r = problem.readings[next];
      delays.update({.is_range = r.is_range, .value = r.value, .std = r.std, .landmark = r.landmark}, k > 25);
    }
    delays.endFrame(k > 25);
  }
  return delays.finding();
}
}  // namespace

TEST(DelayHypotheses, FindALateSensor)
{
  DrivePlan plan;
  plan.duration = 200;
  plan.speed = 1;
  for (const double delay : {-0.15, 0.1, 0.25})
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      plan.delay = delay;
      const std::optional<DelayFinding> found = delayOf(plan, seed);
      ASSERT_TRUE(found) << delay << " " << seed;
      EXPECT_NEAR(found->delay, delay, 0.06) << seed;
    }
}

TEST(DelayHypotheses, ACleanRecordingHasNone)
{
  DrivePlan plan;
  plan.duration = 200;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const std::optional<DelayFinding> found = delayOf(plan, seed);
    EXPECT_TRUE(!found || found->effect < 0.5) << seed << " " << found->delay;
  }
}

TEST(DelayHypotheses, ARobotThatStandsTellsNoDelay)
{
  DrivePlan plan;
  plan.speed = 0;
  plan.weave = 0;
  plan.delay = 0.2;
  EXPECT_FALSE(delayOf(plan, 1));
}
}  // namespace mrpt_ext::test_delay_hypotheses
