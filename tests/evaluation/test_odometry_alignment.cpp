#include "mrpt_ext/evaluation/odometry_alignment.h"

#include <gtest/gtest.h>

#include "hand_made_runs.h"

namespace mrpt_ext::test_odometry_alignment
{
using namespace testing;

namespace
{
/// Drives straight in its own frame, which is turned and moved against the map.
MethodTrajectory odometryInItsOwnFrame()
{
  return movedBy({7, -3, 2.0}, trackWithError(kOdometryMethod, 0, 5, 0.5, [](double) { return 0.0; }));
}
}  // namespace

TEST(OdometryAlignment, AgreesWithTheFirstTruthPoseAndKeepsItsShape)
{
  RunContext context = straightRun(5);
  context.truth.erase(context.truth.begin(), context.truth.begin() + 7);  // truth begins at 0.7 s
  MethodTrajectory odometry = odometryInItsOwnFrame();
  ASSERT_TRUE(alignWithTruth(odometry, context.truth));
  for (const PoseEstimate& point : odometry.points)
  {
    EXPECT_NEAR(point.pose.mean.x, point.time - kLogStart, 1e-9);
    EXPECT_NEAR(point.pose.mean.y, 0, 1e-9);
    EXPECT_NEAR(point.pose.mean.phi, 0, 1e-9);
  }
}

TEST(OdometryAlignment, NeedsATruthHeading)
{
  RunContext context = straightRun(5);
  for (TimedPose& pose : context.truth) pose.heading_known = false;
  MethodTrajectory odometry = odometryInItsOwnFrame();
  EXPECT_FALSE(alignWithTruth(odometry, context.truth));
  EXPECT_NEAR(odometry.points.front().pose.mean.x, 7, 1e-9);
  EXPECT_FALSE(alignWithTruth(odometry, {}));
}

TEST(OdometryAlignment, OtherMethodsStay)
{
  const RunContext context = straightRun(5);
  const RunRecord record = withAlignedOdometry(
      recordOf({odometryInItsOwnFrame(), trackWithError("f", 0, 5, 1, [](double) { return 0.4; })}), context.truth);
  EXPECT_NEAR(record.methods[0].points.front().pose.mean.x, 0, 1e-9);
  EXPECT_NEAR(record.methods[1].points.front().pose.mean.y, 0.4, 1e-9);
}
}  // namespace mrpt_ext::test_odometry_alignment
