#include "mrpt_ext/frames/frame_synchronizer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "frame_sequence.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext::test_frame_synchronizer
{
namespace
{
using testing::buildFrames;
using testing::FrameSequence;

const LandmarkTable kMap({{.id = 1, .position = {4, 1, 0}}, {.id = 2, .position = {-2, 3, 0}}});

/// A robot on a circle: 1 m/s ahead, 0.5 rad/s to the left.
Pose2 poseAt(double time)
{
  const double a = 0.5 * time;
  return {2 * std::sin(a), 2 * (1 - std::cos(a)), wrap(a)};
}

std::vector<Record> odometryUntil(double end)
{
  std::vector<Record> records;
  for (int k = 0; k * 0.01 <= end; ++k) records.emplace_back(OdometryRecord{k * 0.01, poseAt(k * 0.01)});
  return records;
}

const Pose2 kMount{0.2, 0.1, 0.5};

Reading bearingTo(std::size_t landmark, double time, const std::string& sensor = "eye")
{
  Reading reading{.time = time, .sensor = sensor, .T_robot_sensor = kMount};
  reading.detections = {{.id = kMap[landmark].id,
                         .bearing = predictBearing(poseAt(time), kMap[landmark].position.head<2>(), kMount),
                         .std_bearing = 0.01}};
  return reading;
}

FrameSequence framesOf(std::vector<Record> measured, const FrameOptions& options = {})
{
  std::vector<Record> records = odometryUntil(5);
  for (Record& record : measured) records.push_back(std::move(record));
  return buildFrames(records, kMap, options);
}

std::vector<double> stampsOf(const std::vector<Frame>& frames)
{
  std::vector<double> stamps;
  for (const Frame& frame : frames) stamps.push_back(frame.time);
  return stamps;
}
}  // namespace

TEST(FrameSynchronizer, ReadingsWithinTheWindowOfTheFirstAreOneFrame)
{
  const FrameSequence sequence = framesOf(
      {bearingTo(0, 1.0), bearingTo(1, 1.04), bearingTo(0, 1.049, "left"), bearingTo(0, 1.06), bearingTo(0, 1.2)});
  EXPECT_EQ(stampsOf(sequence.frames), (std::vector<double>{1.049, 1.06, 1.2}));
  EXPECT_EQ(sequence.frames[0].readings.size(), 3u);
  EXPECT_EQ(sequence.frames[1].readings.size(), 1u);
  EXPECT_EQ(sequence.detections, 5u);
}

TEST(FrameSynchronizer, RecordsOutOfOrderAreSorted)
{
  const FrameSequence sequence = framesOf({bearingTo(0, 2), bearingTo(1, 1)});
  EXPECT_EQ(stampsOf(sequence.frames), (std::vector<double>{1, 2}));
}

TEST(FrameSynchronizer, EarlierReadingsAreMovedToTheStamp)
{
  const FrameSequence sequence = framesOf({bearingTo(0, 1.0), bearingTo(1, 1.3)}, {.window = 0.5});
  ASSERT_EQ(sequence.frames.size(), 1u);
  ASSERT_EQ(sequence.frames[0].readings.size(), 2u);
  for (const Reading& reading : sequence.frames[0].readings)
  {
    const Detection& d = reading.detections[0];
    const Vector2d landmark = kMap[*kMap.indexOf(d.id)].position.head<2>();
    EXPECT_NEAR(std::abs(wrap(predictBearing(poseAt(1.3), landmark, reading.T_robot_sensor) - *d.bearing)), 0, 1e-6);
  }
  EXPECT_EQ(sequence.frames[0].readings[0].time, 1.0);
}

TEST(FrameSynchronizer, MotionsBetweenFramesAddUpToTheTrajectory)
{
  const FrameSequence sequence = framesOf({bearingTo(0, 1), bearingTo(0, 1.7), bearingTo(0, 3)});
  ASSERT_EQ(sequence.frames.size(), 3u);
  EXPECT_EQ(sequence.frames[0].motion.duration, 0);
  EXPECT_EQ(sequence.frames[0].motion.increment.vector(), Vector3d(0, 0, 0));
  Pose2 robot = poseAt(1);
  for (std::size_t k = 1; k < 3; ++k) robot = compose(robot, sequence.frames[k].motion.increment);
  EXPECT_LT((robot.vector() - poseAt(3).vector()).norm(), 1e-6);
  EXPECT_NEAR(sequence.frames[2].motion.path_length, 1.3, 1e-3);
  EXPECT_NEAR(sequence.frames[2].motion.turned, 0.65, 1e-9);
  EXPECT_NEAR(sequence.frames[2].motion.duration, 1.3, 1e-12);
}

TEST(FrameSynchronizer, OdometryIsCorrectedAsConfigured)
{
  const FrameSequence sequence =
      framesOf({bearingTo(0, 1), bearingTo(0, 2)}, {.odometry = {.scale = 2, .rotation_scale = 0.5, .delay = 0.1}});
  EXPECT_NEAR(sequence.frames[1].motion.path_length, 2, 1e-3);
  EXPECT_NEAR(sequence.frames[1].motion.turned, 0.25, 1e-9);
  EXPECT_NEAR(sequence.odometry.trajectory().front().time, 0.1, 1e-12);
}

TEST(FrameSynchronizer, ObjectsAreSplitOff)
{
  Reading reading = bearingTo(0, 1);
  reading.detections.push_back({.category = "ball", .bearing = 0.2, .std_bearing = 0.01});
  reading.detections.push_back({.category = "cup", .bearing = 0.3, .std_bearing = 0.01});
  reading.detections.push_back({.id = 2, .category = "ball", .bearing = 0.4, .std_bearing = 0.01});  // a landmark
  Reading only_ball{.time = 2, .sensor = "eye"};
  only_ball.detections = {{.category = "ball", .bearing = 0.2, .std_bearing = 0.01}};
  FrameOptions options;
  options.object_categories = {"ball"};
  const FrameSequence sequence = framesOf({reading, only_ball}, options);
  ASSERT_EQ(sequence.frames.size(), 1u);
  EXPECT_EQ(sequence.frames[0].readings[0].detections.size(), 3u);
  EXPECT_EQ(stampsOf(sequence.object_frames), (std::vector<double>{1, 2}));
  ASSERT_EQ(sequence.object_frames[0].readings[0].detections.size(), 1u);
  EXPECT_EQ(*sequence.object_frames[0].readings[0].detections[0].bearing, 0.2);
  EXPECT_EQ(sequence.detections, 3u);
  EXPECT_TRUE(framesOf({reading, only_ball}).object_frames.empty());
}

TEST(FrameSynchronizer, EmptyReadingsCountOnlyWhereMissedDetectionsAreScored)
{
  const Reading nothing{.time = 1, .sensor = "eye"};
  EXPECT_TRUE(framesOf({nothing}).frames.empty());
  FrameOptions options;
  options.sensors["eye"].detection_probability = 0.8;
  const FrameSequence sequence = framesOf({nothing}, options);
  ASSERT_EQ(sequence.frames.size(), 1u);
  EXPECT_TRUE(sequence.frames[0].readings[0].detections.empty());
  EXPECT_EQ(sequence.detections, 0u);
}

TEST(FrameSynchronizer, TheNewestCompassIsMovedToTheStamp)
{
  const auto north = [](double time) { return CompassRecord{time, "north", poseAt(time).phi, 0.02}; };
  const FrameSequence sequence =
      framesOf({north(0.5), north(0.9), bearingTo(0, 1.2), bearingTo(0, 2), north(2.5), bearingTo(0, 2.5)});
  ASSERT_EQ(sequence.frames.size(), 3u);
  ASSERT_TRUE(sequence.frames[0].compass);
  EXPECT_NEAR(sequence.frames[0].compass->heading, 0.6, 1e-9);
  EXPECT_FALSE(sequence.frames[1].compass);
  ASSERT_TRUE(sequence.frames[2].compass);
  EXPECT_NEAR(sequence.frames[2].compass->heading, 1.25, 1e-9);
}

TEST(FrameSynchronizer, RunningFixesWhoseRangesAreLoggedTooAreMarked)
{
  RunningFixReading fix{.time = 2, .first_time = 1, .sensor = "sonar", .id = 1, .first_range = 3, .first_std = 0.1};
  fix.second_range = 3;
  fix.second_std = 0.1;
  const auto marked = [&](const std::vector<Record>& others)
  {
    std::vector<Record> records = others;
    records.emplace_back(fix);
    const FrameSequence sequence = framesOf(records);
    EXPECT_EQ(sequence.frames.back().fixes.size(), 1u);
    return sequence.frames.back().fixes[0].ranges_logged_too;
  };
  Reading range{.time = 1, .sensor = "sonar"};
  range.detections = {{.id = 1, .range = 3, .std_range = 0.1}};
  EXPECT_FALSE(marked({}));
  EXPECT_TRUE(marked({range}));
  EXPECT_FALSE(marked({bearingTo(0, 1, "sonar")}));
  range.detections[0].id = 2;
  EXPECT_FALSE(marked({range}));
}

TEST(FrameSynchronizer, RunningFixesAreMovedToTheStampToo)
{
  RunningFixReading fix{.time = 2, .first_time = 1, .sensor = "sonar", .T_robot_sensor = kMount, .id = 1};
  const Vector2d landmark = kMap[0].position.head<2>();
  fix.first_range = predictRange(poseAt(1), landmark, kMount);
  fix.second_range = predictRange(poseAt(2), landmark, kMount);
  fix.first_std = fix.second_std = 0.1;
  fix.displacement = between(poseAt(1), poseAt(2));
  const FrameSequence sequence = framesOf({fix, bearingTo(0, 2.4)}, {.window = 0.5});
  ASSERT_EQ(sequence.frames.size(), 1u);
  const std::vector<Reading> ranges = asReadings(sequence.frames[0].fixes.at(0));
  ASSERT_EQ(ranges.size(), 2u);
  for (const Reading& reading : ranges)
    EXPECT_NEAR(predictRange(poseAt(2.4), landmark, reading.T_robot_sensor), *reading.detections[0].range, 1e-6);
}

TEST(FrameSynchronizer, IndependentFramesHaveNoMotion)
{
  const FrameSequence sequence =
      framesOf({bearingTo(0, 1), bearingTo(1, 1.3), bearingTo(0, 3)}, {.window = 0.5, .independent = true});
  ASSERT_EQ(sequence.frames.size(), 2u);
  EXPECT_EQ(sequence.frames[1].motion.path_length, 0);
  EXPECT_EQ(sequence.frames[1].motion.duration, 0);
  for (const Reading& reading : sequence.frames[0].readings)
    EXPECT_EQ(reading.T_robot_sensor.vector(), kMount.vector());
}

TEST(FrameSynchronizer, IgnoredSensorsAndUnusableDetectionsAreLeftOut)
{
  FrameOptions options;
  options.sensors["left"].ignore = true;
  Reading stranger = bearingTo(0, 2);
  stranger.detections[0].id = 77;
  const FrameSequence sequence = framesOf({bearingTo(0, 1, "left"), stranger, bearingTo(0, 3)}, options);
  EXPECT_EQ(stampsOf(sequence.frames), (std::vector<double>{3}));
  EXPECT_EQ(sequence.unusable, (UnusableDetections{{"eye: id not in the map", 1}}));
  EXPECT_EQ(sequence.detections, 1u);
}

TEST(FrameSynchronizer, SensorDelaysMoveReadingsBackInTime)
{
  FrameOptions options;
  options.sensors["left"].delay = 0.5;
  Reading late = bearingTo(1, 1, "left");  // what it saw at 1 s arrives at 1.5 s
  late.time = 1.5;
  const FrameSequence sequence = framesOf({bearingTo(0, 1.0), late}, options);
  ASSERT_EQ(sequence.frames.size(), 1u);
  EXPECT_EQ(sequence.frames[0].readings.size(), 2u);
}

TEST(FrameSynchronizer, AnEmptyLogHasNoFrames)
{
  const FrameSequence sequence = buildFrames({}, kMap, {});
  EXPECT_TRUE(sequence.frames.empty());
  EXPECT_TRUE(sequence.odometry.empty());
}

TEST(FrameSynchronizer, ReadsNoFurtherThanTheWindowAndTheDelaysRequire)
{
  constexpr double kStep = 0.1, kDelay = 0.35;
  std::vector<Record> records;
  for (int k = 0; k < 300; ++k) records.emplace_back(bearingTo(0, k * kStep, k % 2 == 0 ? "eye" : "left"));
  FrameOptions options;
  options.sensors["left"].delay = kDelay;
  const RecordStream all = streamOf(records);
  double newest = 0;
  const auto watched = [&]
  {
    auto record = all();
    if (record) newest = timeOf(*record);
    return record;
  };
  const LogOverview overview;
  FrameSynchronizer cutter(watched, kMap, options, overview);
  std::vector<double> stamps;
  while (const auto frame = cutter.next())
  {
    EXPECT_LE(newest, frame->time + options.window + kDelay + 5 * kStep);
    stamps.push_back(frame->time);
  }
  EXPECT_EQ(newest, timeOf(records.back()));
  EXPECT_TRUE(std::is_sorted(stamps.begin(), stamps.end()));
  EXPECT_EQ(stamps, stampsOf(buildFrames(records, kMap, options).frames));
  EXPECT_EQ(cutter.detections(), records.size());
  EXPECT_FALSE(cutter.next());
}

TEST(FrameSynchronizer, RangesAreKeptAsLongAsAFixMayNeedThem)
{
  Reading range{.time = 1, .sensor = "sonar"};
  range.detections = {{.id = 1, .range = 3, .std_range = 0.1}};
  RunningFixReading fix{.time = 61, .first_time = 1, .sensor = "sonar", .id = 1, .first_range = 3, .first_std = 0.1};
  fix.second_range = 4;
  fix.second_std = 0.1;
  std::vector<Record> records{range};
  for (int k = 2; k < 61; ++k) records.emplace_back(bearingTo(0, k));
  records.emplace_back(fix);
  EXPECT_TRUE(buildFrames(records, kMap, {}).frames.back().fixes.at(0).ranges_logged_too);
  records.front() = bearingTo(0, 1);
  EXPECT_FALSE(buildFrames(records, kMap, {}).frames.back().fixes.at(0).ranges_logged_too);
}
}  // namespace mrpt_ext::test_frame_synchronizer
