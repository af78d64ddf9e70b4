#include "mrpt_ext/importers/rosbag2/rosbag2_recording.h"

#include <gtest/gtest.h>

#include <map>

#include "bag_samples.h"
#include "sample_data.h"

// The bags hold exact measurements of four posts by sensors that sit on the robot in different ways.
namespace mrpt_ext::test_rosbag2_recording
{
namespace
{
using testing::bag;

Recording imported(const std::string& name, Rosbag2Options options = {})
{
  options.map = bag("landmarks.csv");
  return importRosbag2({bag(name)}, options);
}

/// Readings by sensor.
std::map<std::string, std::vector<Reading>> readingsIn(const Recording& recording)
{
  std::map<std::string, std::vector<Reading>> readings;
  for (const Reading& reading : testing::recordsOf<Reading>(recording)) readings[reading.sensor].push_back(reading);
  return readings;
}

/// Where a detection with range and bearing lies on the map, by the truth.
Vector2d positionOf(const Detection& detection, const Reading& reading, const Trajectory& truth, double horizontal)
{
  const Pose2 sensor = compose(interpolate(truth, reading.time, 0.2)->pose, reading.T_robot_sensor);
  return transform(sensor, horizontal * Vector2d(std::cos(*detection.bearing), std::sin(*detection.bearing)));
}

/// Distance to the post of that id, else to the nearest one.
double distanceToPost(const Vector2d& point, int id, const LandmarkTable& map)
{
  double nearest = 100;
  for (const Landmark& post : map.all())
    if (id == kNoId || post.id == id) nearest = std::min(nearest, (post.position.head<2>() - point).norm());
  return nearest;
}

void expectOnPosts(const Reading& reading, const Recording& recording, double within)
{
  for (const Detection& detection : reading.detections)
  {
    if (!detection.bearing || !detection.range) continue;
    const double rise = reading.horizontal_range ? 0 : 1 - reading.sensor_height;  // the posts are one metre high
    const double horizontal = std::sqrt(square(*detection.range) - square(rise));
    const Vector2d point = positionOf(detection, reading, recording.truth, horizontal);
    EXPECT_LT(distanceToPost(point, detection.id, recording.map), within) << reading.sensor << " at " << reading.time;
  }
}
}  // namespace

TEST(Rosbag2Recording, PutsEveryDetectionOnItsLandmark)
{
  const Recording recording = imported("drive_zstd.mcap");
  auto readings = readingsIn(recording);
  EXPECT_EQ(readings["nav350_landmarks"].size(), 5U);
  EXPECT_EQ(readings["camera_detections"].size(), 5U);
  EXPECT_EQ(readings["objects"].size(), 5U);
  for (const Reading& reading : readings["nav350_landmarks"])
  {
    EXPECT_EQ(reading.detections.size(), 4U);
    expectOnPosts(reading, recording, 0.003);
  }
  for (const Reading& reading : readings["objects"]) expectOnPosts(reading, recording, 1e-6);
  for (const Reading& reading : readings["camera_detections"]) expectOnPosts(reading, recording, 1e-5);
}

TEST(Rosbag2Recording, BearingsOfTagsAreThoseOfATiltedCamera)
{
  const Recording recording = imported("drive_zstd.mcap");
  std::size_t with_range = 0, without_range = 0;
  const auto readings = readingsIn(recording);
  for (const Reading& reading : readings.at("camera_detections"))
  {
    const Pose2 camera = compose(interpolate(recording.truth, reading.time, 0.2)->pose, reading.T_robot_sensor);
    EXPECT_NEAR(reading.sensor_height, 0.6, 1e-9);
    for (const Detection& detection : reading.detections)
    {
      const Vector3d post = recording.map[*recording.map.indexOf(detection.id)].position;
      const Vector2d way = post.head<2>() - camera.position();
      EXPECT_NEAR(wrap(*detection.bearing + camera.phi - std::atan2(way.y(), way.x())), 0, 1e-5);
      ++(detection.range ? with_range : without_range);
    }
  }
  EXPECT_GT(with_range, 0U);
  EXPECT_GT(without_range, 0U);
}

TEST(Rosbag2Recording, ObjectsHaveNamesAndStatedNoise)
{
  const auto readings = readingsIn(imported("drive_zstd.mcap"))["objects"];
  ASSERT_FALSE(readings.empty());
  const auto& detections = readings[0].detections;
  ASSERT_EQ(detections.size(), 4U);
  EXPECT_EQ(detections[0].id, kNoId);
  EXPECT_EQ(detections[0].category, "post");
  EXPECT_EQ(detections[1].id, 2);
  EXPECT_NEAR(detections[1].std_range, 0.02, 1e-9);
  EXPECT_EQ(detections[3].id, kNoId);  // without a hypothesis
}

TEST(Rosbag2Recording, OdometryTruthAndRangesAreTaken)
{
  const Recording recording = imported("drive_zstd.mcap");
  const auto odometry = testing::recordsOf<OdometryRecord>(recording);
  ASSERT_EQ(odometry.size(), 51U);
  EXPECT_NEAR(odometry[10].time, 1700000001.25, 1e-6);
  ASSERT_EQ(recording.truth.size(), 51U);
  for (std::size_t i = 0; i < odometry.size(); ++i)
  {
    const Pose2 expected = between(recording.truth[0].pose, recording.truth[i].pose);
    EXPECT_NEAR((odometry[i].pose.vector() - expected.vector()).norm(), 0, 1e-6);
  }
  const auto radio = readingsIn(recording)["radio"];
  ASSERT_EQ(radio.size(), 4U);
  EXPECT_EQ(radio[0].detections[0].id, 12);
  EXPECT_TRUE(testing::hasNote(recording, "1 /radio: messages without a range within the sensor's limits dropped"));
  EXPECT_TRUE(testing::hasNote(recording, "/chatter (std_msgs/msg/String, 5 messages): ignored, not about landmarks"));
  EXPECT_TRUE(testing::hasNote(recording, "/goal_pose (geometry_msgs/msg/PoseStamped, 5 messages): ignored, a pose"));
}

TEST(Rosbag2Recording, AScannerUpsideDownTurnsTheOtherWayRound)
{
  const auto scans = testing::recordsOf<RangeScan>(imported("drive_zstd.mcap"));
  ASSERT_EQ(scans.size(), 5U);
  EXPECT_EQ(scans[0].sensor, "scan");
  EXPECT_EQ(scans[0].ranges.size(), 271U);
  EXPECT_NEAR(scans[0].bearing_step, -degToRad(1), 1e-6);
  EXPECT_NEAR(scans[0].first_bearing, degToRad(135), 1e-6);
  EXPECT_NEAR(scans[0].T_robot_sensor.phi, degToRad(30), 1e-9);
}

TEST(Rosbag2Recording, EveryStorageGivesTheSame)
{
  const Recording zstd = imported("drive_zstd.mcap");
  for (const char* name : {"drive_lz4.mcap", "two_files"})
  {
    const Recording other = imported(name);
    ASSERT_EQ(other.records.size(), zstd.records.size()) << name;
    for (std::size_t i = 0; i < zstd.records.size(); ++i) EXPECT_EQ(timeOf(other.records[i]), timeOf(zstd.records[i]));
    EXPECT_EQ(other.truth.size(), zstd.truth.size());
  }
}

TEST(Rosbag2Recording, OdometryMayComeFromTransforms)
{
  Rosbag2Options options;
  addTopicRequest(options.topics, "odometry=/tf");
  const auto odometry = testing::recordsOf<OdometryRecord>(imported("drive_zstd.mcap", options));
  const auto messages = testing::recordsOf<OdometryRecord>(imported("drive_zstd.mcap"));
  ASSERT_EQ(odometry.size(), messages.size());
  EXPECT_NEAR((odometry[20].pose.vector() - messages[20].pose.vector()).norm(), 0, 1e-9);
}

TEST(Rosbag2Recording, AnotherFrameMayBeTheRobots)
{
  Rosbag2Options options;
  options.base = "camera_optical";
  addTopicRequest(options.topics, "truth=none");
  const Recording recording = imported("drive_zstd.mcap", options);
  EXPECT_TRUE(recording.truth.empty());
  EXPECT_TRUE(testing::hasNote(recording, "the robot's frame is 'camera_optical'"));
  const Reading reading = readingsIn(recording)["camera_detections"][0];
  EXPECT_NEAR(reading.T_robot_sensor.x, 0, 1e-9);
  EXPECT_NEAR(reading.T_robot_sensor.y, 0, 1e-9);
}

TEST(Rosbag2Recording, DamagedMessagesAreALine)
{
  const testing::ScratchFolder folder;
  std::string bytes = readTextFile(bag("plain.mcap"));
  bytes.replace(bytes.find("base_link"), 1, std::string(1, '\0'));
  EXPECT_NO_THROW(static_cast<void>(importRosbag2({folder.write("renamed.mcap", bytes)}, {})));
  const std::string quaternion("\0\0\0\0\0\0\xF0\x3F", 8);  // 1.0
  std::string odd = readTextFile(bag("plain.mcap"));
  for (std::size_t at = odd.find("odom\0", 0, 5); (at = odd.find(quaternion, at)) != std::string::npos;)
    odd.replace(at, 8, std::string("\0\0\0\0\0\0\xF8\x7F", 8));
  EXPECT_INPUT_ERROR(static_cast<void>(importRosbag2({folder.write("odd.mcap", odd)}, {})), "odd.mcap: message ");
}
}  // namespace mrpt_ext::test_rosbag2_recording
