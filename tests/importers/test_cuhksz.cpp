#include "mrpt_ext/importers/cuhksz.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "sample_data.h"

namespace mrpt_ext::test_cuhksz
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

TEST(Cuhksz, EveryTagIsASensorWithItsPositionOnTheBody)
{
  const Recording recording = importCuhksz(testing::sampleFolder("cuhksz"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 8u) << "one of nine has no range";
  EXPECT_EQ(readings[0].sensor, "tag0");
  EXPECT_EQ(readings[2].sensor, "tag2");
  EXPECT_EQ(readings[2].T_robot_sensor.position(), Vector2d(0.2034, 0.1451));
  EXPECT_NEAR(readings[2].sensor_height, 0.9692, 1e-9);
  ASSERT_EQ(readings[2].detections.size(), 8u);
  EXPECT_EQ(readings[2].detections[1].id, 1);
  EXPECT_EQ(readings[2].detections[1].range, 0.94);
  EXPECT_NEAR(readings[5].time - readings[0].time, 0.019, 1e-6);
  EXPECT_TRUE(hasNote(recording, "9 ranges are empty or 0: not measured"));
  EXPECT_TRUE(hasNote(recording, "1 readings of a tag without any range dropped"));
  EXPECT_EQ(recording.map.size(), 8u);
}

TEST(Cuhksz, TruthIsWhereTheBodyAxisPoints)
{
  const Recording recording = importCuhksz(testing::sampleFolder("cuhksz"));
  ASSERT_EQ(recording.truth.size(), 2u);
  EXPECT_TRUE(hasNote(recording, "1 poses of the truth share the stamp"));
  EXPECT_NEAR(recording.truth[0].pose.phi, 0, 1e-9) << "upside down, x axis ahead";
  EXPECT_NEAR(recording.truth[1].pose.phi, kPi / 4, 1e-6);
  EXPECT_NEAR(recordsOf<Reading>(recording)[0].time - recording.truth[0].time, 0.006, 1e-6);
}

TEST(Cuhksz, DamagedFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("cuhksz");
  const auto import = [&] { (void)importCuhksz(copy.path()); };
  const std::string ranges = ",1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1";
  const std::string good = "2022-08-15 9:42:24.766,1" + ranges + "\n";
  copy.replace("UWB_walk.csv", good + "2022-08-15 9:42:24.776,1,2\n");
  EXPECT_INPUT_ERROR(import(), "UWB_walk.csv:2: 3 fields, expected 25");
  copy.replace("UWB_walk.csv", good + "2022-08-15 9:42:24.700,1" + ranges + "\n");
  EXPECT_INPUT_ERROR(import(), "UWB_walk.csv:2: time 2022-08-15 9:42:24.700 is before the row above");
  copy.replace("UWB_walk.csv", good + "2022-13-15 9:42:24.776,1" + ranges + "\n");
  EXPECT_INPUT_ERROR(import(), "UWB_walk.csv:2: '2022-13-15 9:42:24.776' is no date and time");
  copy.replace("UWB_walk.csv", good + "2022-08-15 9:42:24.776,1230" + ranges + "\n");
  EXPECT_INPUT_ERROR(import(), "UWB_walk.csv:2: range 1230, expected metres within 0 ... 100 (a0-t0)");
  copy.replace("UWB_walk.csv", good);
  copy.replace("motion_capture_walk.csv", "time,x,y,z,rotation,,,\n2022-08-15 9:42:24.760,0,0,1,0,0.5,0,0\n");
  EXPECT_INPUT_ERROR(import(), "motion_capture_walk.csv:2: quaternion of squared length 0.250, expected 1");
  copy.remove("motion_capture_walk.csv");
  EXPECT_TRUE(hasNote(importCuhksz(copy.path()), "no truth file"));
}

// The ranges are 0.18 m too long; their error scatters by 0.1 m once body frame and its axes are understood.
TEST(CuhkszRecordings, RangesFitTheTruth)
{
  const auto folder = testing::recordingsFolder("cuhksz_uwb_planar");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ", set LANDMARK_DATA_DIR";
  const Recording recording = importCuhksz(folder / "dynamic_exp_fast");
  const auto readings = recordsOf<Reading>(recording);
  EXPECT_EQ(readings.size(), 3u * 13481u);
  double sum = 0, squares = 0;
  std::size_t count = 0, next = 0;
  for (std::size_t i = 0; i < readings.size(); i += 31)
  {
    while (next + 1 < recording.truth.size() && recording.truth[next].time < readings[i].time) ++next;
    const Pose2 sensor = compose(recording.truth[next].pose, readings[i].T_robot_sensor);
    for (const Detection& detection : readings[i].detections)
    {
      const Vector3d anchor = recording.map[recording.map.indexOf(detection.id).value()].position;
      const double distance =
          std::hypot((anchor.head<2>() - sensor.position()).norm(), anchor.z() - readings[i].sensor_height);
      sum += *detection.range - distance;
      squares += square(*detection.range - distance);
      ++count;
    }
  }
  const double mean = sum / static_cast<double>(count);
  EXPECT_NEAR(mean, 0.181, 0.01);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(count) - square(mean)), kCuhkszStdRange, 0.01);
}
}  // namespace mrpt_ext::test_cuhksz
