#include "mrpt_ext/importers/truth_heading.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mrpt_ext/importers/velocity_odometry.h"
#include "sample_data.h"

namespace mrpt_ext::test_truth_heading
{
namespace
{
/// A winding path of 30 m; the heading is off the direction of motion by `offset`.
Trajectory windingPath(double offset)
{
  Trajectory path;
  Pose2 pose{1, 2, 0.3};
  for (int i = 0; i < 1000; ++i)
  {
    path.push_back({0.1 * i, {pose.x, pose.y, wrap(pose.phi + offset)}, true});
    pose = compose(pose, arcMotion(0.3, 0.4 * std::sin(0.02 * i), 0.1));
  }
  return path;
}

Recording recordingWith(const Trajectory& truth, const Trajectory& odometry)
{
  Recording recording;
  recording.truth = truth;
  for (const TimedPose& entry : odometry) recording.records.emplace_back(OdometryRecord{entry.time, entry.pose});
  return recording;
}
}  // namespace

RC_GTEST_PROP(TruthHeading, ConstantOffsetIsFoundAndCorrected, ())
{
  const double offset = degToRad(*rc::gen::inRange(6, 355));
  Recording recording = recordingWith(windingPath(offset), {});
  correctTruthHeading(recording);
  const Trajectory right = windingPath(0);
  for (std::size_t i = 0; i < right.size(); ++i)
    RC_ASSERT(std::abs(wrap(recording.truth[i].pose.phi - right[i].pose.phi)) < degToRad(0.5));
  RC_ASSERT(recording.notes.size() == 1u);
  RC_ASSERT(recording.notes[0].starts_with("warning: the truth heading"));
}

TEST(TruthHeading, SmallOffsetsAreLeftAlone)
{
  EXPECT_FALSE(truthHeadingOffset(recordingWith(windingPath(degToRad(3)), {})));
}

TEST(TruthHeading, RobotThatDrivesBackwardsInItsOdometryIsRight)
{
  EXPECT_FALSE(truthHeadingOffset(recordingWith(windingPath(kPi), windingPath(kPi))));
  const auto offset = truthHeadingOffset(recordingWith(windingPath(0), windingPath(kPi)));
  ASSERT_TRUE(offset);
  EXPECT_NEAR(std::abs(wrap(*offset - kPi)), 0, degToRad(0.5));
}

TEST(TruthHeading, MotionInAllDirectionsIsNoOffset)
{
  Trajectory sideways = windingPath(0);
  for (std::size_t i = 0; i < sideways.size(); ++i) sideways[i].pose.phi = 0.006 * static_cast<double>(i);
  EXPECT_FALSE(truthHeadingOffset(recordingWith(sideways, {})));
}

TEST(TruthHeading, UnknownHeadingsAndShortPathsGiveNoOffset)
{
  Trajectory unknown = windingPath(1);
  for (TimedPose& entry : unknown) entry.heading_known = false;
  EXPECT_FALSE(truthHeadingOffset(recordingWith(unknown, {})));
  const Trajectory path = windingPath(1);
  EXPECT_FALSE(truthHeadingOffset(recordingWith(Trajectory(path.begin(), path.begin() + 50), {})));
}
}  // namespace mrpt_ext::test_truth_heading
