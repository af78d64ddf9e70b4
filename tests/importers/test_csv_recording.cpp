#include "mrpt_ext/importers/csv_recording.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"
#include "sample_data.h"

namespace mrpt_ext::test_csv_recording
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

namespace
{
Recording importFolder(const std::filesystem::path& folder) { return importCsv(findCsvFiles({folder})); }
}  // namespace

TEST(CsvRecording, RowsOfOneTimeAndSensorAreOneReading)
{
  const Recording recording = importFolder(testing::sampleFolder("csv"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 3u);
  EXPECT_EQ(readings[0].sensor, "omni");
  ASSERT_EQ(readings[0].detections.size(), 2u);
  EXPECT_FALSE(readings[0].detections[0].range);
  EXPECT_NEAR(*readings[0].detections[1].bearing, degToRad(100.5), 1e-12);
  EXPECT_NEAR(readings[0].detections[1].std_bearing, degToRad(1), 1e-12);
  EXPECT_EQ(readings[0].detections[1].std_range, 0.2);
  EXPECT_EQ(readings[1].sensor, "stereo");
  EXPECT_EQ(readings[1].detections[0].id, kNoId);
  EXPECT_EQ(readings[1].detections[0].category, "pole");
  EXPECT_FALSE(readings[1].detections[0].bearing);
  EXPECT_NEAR(*readings[2].detections[0].bearing, degToRad(-170), 1e-12);
}

TEST(CsvRecording, OdometryIsOptional)
{
  const DamagedCopy copy("csv");
  std::filesystem::remove(copy.path() / "odometry.csv");
  const Recording recording = importFolder(copy.path());
  EXPECT_TRUE(recordsOf<OdometryRecord>(recording).empty());
  EXPECT_EQ(recordsOf<Reading>(recording).size(), 3U);
  EXPECT_TRUE(hasNote(recording, "no odometry.csv"));
}

// As in the folder of the Car Park recording: the detections that were made of the scans are there, too.
TEST(CsvRecording, ScansBesideDetectionsNeedTheBearingsOfTheirBeams)
{
  const DamagedCopy copy("csv");
  const std::string scans = "t,r0,r1,i0,i1\n0.5,8.1,3.25,120,9000\n";
  copy.replace("scans.csv", scans);
  const Recording without = importFolder(copy.path());
  EXPECT_TRUE(recordsOf<RangeScan>(without).empty());
  EXPECT_EQ(recordsOf<Reading>(without).size(), 3U);
  EXPECT_TRUE(hasNote(without, "scans.csv: left out"));

  copy.replace("sensors.csv",
               "sensor,x,y,z,yaw_deg,first_bearing_deg,last_bearing_deg\nomni,0,0,0,0,,\nstereo,0,0,0,0,,\n"
               "laser,0,0,0,0,-90,90\n");
  EXPECT_EQ(recordsOf<RangeScan>(importFolder(copy.path())).size(), 1U);
  std::filesystem::remove(copy.path() / "sensors.csv");
  std::filesystem::remove(copy.path() / "detections.csv");
  EXPECT_INPUT_ERROR(importFolder(copy.path()), "scans.csv:2: a scan of sensor 'laser', expected its row");
}

TEST(CsvRecording, VelocitiesAreIntegratedAndPosesTakenAsTheyAre)
{
  const auto arcs = recordsOf<OdometryRecord>(importFolder(testing::sampleFolder("csv")));
  ASSERT_EQ(arcs.size(), 3u);
  EXPECT_NEAR(arcs[2].pose.x, 1 + 2 / kPi, 1e-12);
  EXPECT_NEAR(arcs[2].pose.phi, kPi / 2, 1e-12);

  const DamagedCopy copy("csv");
  copy.replace("odometry.csv", "phi_deg,t,x,y\n450,0,1,2\n0,0,3,4\n10,1,5,6\n");
  const Recording recording = importFolder(copy.path());
  const auto poses = recordsOf<OdometryRecord>(recording);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].pose.vector(), Vector3d(3, 4, 0));
  EXPECT_NEAR(poses[1].pose.phi, degToRad(10), 1e-12);
  EXPECT_TRUE(hasNote(recording, "1 odometry rows share the stamp"));
}

TEST(CsvRecording, TruthIsOptionalAndThreePathsDoAsWell)
{
  const auto folder = testing::sampleFolder("csv");
  EXPECT_EQ(importFolder(folder).truth.size(), 2u);
  const Recording recording =
      importCsv(findCsvFiles({folder / "landmarks.csv", folder / "odometry.csv", folder / "detections.csv"}));
  EXPECT_TRUE(recording.truth.empty());
  EXPECT_TRUE(hasNote(recording, "no truth file"));
  EXPECT_INPUT_ERROR((void)findCsvFiles({folder, folder}), "2 inputs, expected a folder or LANDMARKS");
  EXPECT_INPUT_ERROR((void)findCsvFiles({folder / "none"}), "none: no such folder");
}

TEST(CsvRecording, SensorsAreMountedWhereTheirFileSays)
{
  const DamagedCopy copy("csv");
  EXPECT_TRUE(hasNote(importFolder(copy.path()), "no sensors.csv: all sensors are at the robot's origin"));
  copy.replace("sensors.csv", "sensor,x,y,z,yaw_deg\nomni,0.2,0,1.5,0\nstereo,-0.1,0.3,0.5,90\nspare,0,0,0,0\n");
  const Recording recording = importFolder(copy.path());
  const auto readings = recordsOf<Reading>(recording);
  EXPECT_EQ(readings[0].T_robot_sensor.vector(), Vector3d(0.2, 0, 0));
  EXPECT_EQ(readings[0].sensor_height, 1.5);
  EXPECT_NEAR(readings[1].T_robot_sensor.phi, kPi / 2, 1e-12);
  EXPECT_TRUE(hasNote(recording, "sensor 'spare' has no detections"));
  copy.replace("sensors.csv", "sensor,x,y,z,yaw_deg\nomni,0,0,0,0\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "sensors.csv: no row for sensor 'stereo' of the detections");
  copy.replace("sensors.csv", "sensor,x,y,z,yaw_deg\nomni,0,0,0,0\nomni,0,0,0,0\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "sensors.csv:3: sensor 'omni' occurs twice");
  copy.replace("sensors.csv", "sensor,x,y,z,yaw\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "sensors.csv:1: unknown column 'yaw'");
}

// A car with axles 2 m apart and wheels at 45 degrees turns about a point 2 m to its left.
TEST(CsvRecording, SpeedAndSteeringAreTheArcsOfACar)
{
  const DamagedCopy copy("csv");
  copy.replace("odometry.csv", "t,speed_m_s,steering_rad\n0,3.141592653589793,0.7853981633974483\n1,0,0\n");
  CsvFiles files = findCsvFiles({copy.path()});
  EXPECT_INPUT_ERROR((void)importCsv(files),
                     "odometry.csv: steering_rad needs the distance of the axles, set --wheelbase");
  files.wheelbase = 2;
  const auto odometry = recordsOf<OdometryRecord>(importCsv(files));
  ASSERT_EQ(odometry.size(), 2U);
  EXPECT_NEAR(odometry[1].pose.x, 2, 1e-9);
  EXPECT_NEAR(odometry[1].pose.y, 2, 1e-9);
  EXPECT_NEAR(odometry[1].pose.phi, kPi / 2, 1e-9);
  copy.replace("odometry.csv", "t,speed_m_s,steering_rad\n0,1,45\n");
  EXPECT_INPUT_ERROR((void)importCsv(files), "odometry.csv:2: steering_rad 45, expected radians");
  copy.replace("odometry.csv", "t,v,omega_deg_s\n0,1,4\n");
  EXPECT_INPUT_ERROR((void)importCsv(files), "--wheelbase: ");
}

// Its left wheel, 1 m from the middle, drives half the way; the scanner is 1 m ahead of the axle.
TEST(CsvRecording, SpeedOfAWheelAndFrameOfASensor)
{
  const DamagedCopy copy("csv");
  copy.replace("odometry.csv", "t,speed_m_s,steering_rad\n0,1.5707963267948966,0.7853981633974483\n1,0,0\n");
  copy.replace("sensors.csv", "sensor,x,y,z,yaw_deg\nomni,1,0,1,0\nstereo,0,0,0.8,90\n");
  CsvFiles files = findCsvFiles({copy.path()});
  files.wheelbase = 2;
  files.wheel_offset = 1;
  const auto axle = recordsOf<OdometryRecord>(importCsv(files));
  EXPECT_NEAR((axle.at(1).pose.vector() - Vector3d(2, 2, kPi / 2)).norm(), 0, 1e-9);
  files.base = "omni";
  const Recording moved = importCsv(files);
  const auto sensor = recordsOf<OdometryRecord>(moved);
  EXPECT_NEAR((sensor.at(0).pose.vector() - Vector3d(1, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((sensor.at(1).pose.vector() - Vector3d(2, 3, kPi / 2)).norm(), 0, 1e-9);
  for (const Reading& reading : recordsOf<Reading>(moved))
    EXPECT_NEAR(reading.T_robot_sensor.x, reading.sensor == "omni" ? 0 : -1, 1e-9);
  files.base = "rear";
  EXPECT_INPUT_ERROR((void)importCsv(files), "--base rear: ");
  files.base = "";
  files.wheel_offset = 2;
  EXPECT_INPUT_ERROR((void)importCsv(files), "odometry.csv:2: steering_rad 0.7853981633974483 puts the centre");
}

TEST(CsvRecording, AFieldLayoutStandsForLandmarksCsv)
{
  const DamagedCopy copy("csv");
  copy.replace("landmarks.json", R"({"tags": [{"ID": 7, "pose": {"translation": {"x": 1, "y": 2, "z": 1.4}}}]})");
  EXPECT_INPUT_ERROR((void)findCsvFiles({copy.path()}), "landmarks.json: a second map beside");
  copy.remove("landmarks.csv");
  EXPECT_EQ(importFolder(copy.path()).map[0].id, 7);
}

TEST(CsvRecording, SemicolonsAreNamed)
{
  const DamagedCopy copy("csv");
  copy.replace("landmarks.csv", "id;x;y;z;category\n1;4,5;0;0;pole\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()),
                     "landmarks.csv:1: fields are separated by semicolons, expected commas");
}

TEST(CsvRecording, MistakesInDetectionsAreNamedWithTheirLine)
{
  const DamagedCopy copy("csv");
  const auto import = [&](const std::string& rows)
  {
    copy.replace("detections.csv", "t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m\n" + rows);
    (void)importFolder(copy.path());
  };
  EXPECT_INPUT_ERROR(import("1,a,,,10,,1\n"), "detections.csv:2: 7 fields, expected 8");
  EXPECT_INPUT_ERROR(import("1,a,,,ten,,1,\n"), "detections.csv:2: 'ten' is not a number, expected bearing_deg");
  EXPECT_INPUT_ERROR(import("1,a,,,361,,1,\n"), "detections.csv:2: bearing_deg 361 is out of range");
  EXPECT_INPUT_ERROR(import("1,a,,,,-2,,1\n"), "detections.csv:2: range_m -2 is out of range, expected >= 0");
  EXPECT_INPUT_ERROR(import("1,a,,,,2,,-1\n"), "detections.csv:2: std_range_m is '-1', expected");
  EXPECT_INPUT_ERROR(import("1,a,,,10,,,\n"), "detections.csv:2: std_bearing_deg is '', expected");
  EXPECT_INPUT_ERROR(import("1,a,,,,,1,1\n"), "detections.csv:2: neither bearing_deg nor range_m");
  EXPECT_INPUT_ERROR(import("1,,,,10,,1,\n"), "detections.csv:2: no sensor");
  EXPECT_INPUT_ERROR(import("1,a,p1,,10,,1,\n"), "detections.csv:2: 'p1' is not an integer, expected id");
  EXPECT_INPUT_ERROR(import("1,a,-2,,10,,1,\n"), "detections.csv:2: id -2, expected >= 0");
  EXPECT_INPUT_ERROR(import("2,a,,,10,,1,\n1,a,,,10,,1,\n"), "detections.csv:3: time 1 is before the row above");
  copy.replace("detections.csv", "t,sensor,id,category,bearing,range_m,std_bearing_deg,std_range_m\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()),
                     "detections.csv:1: unknown column 'bearing', expected only t,sensor");
  copy.remove("detections.csv");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "detections.csv: no such file");
}

TEST(CsvRecording, ColumnsOfWhatIsNotMeasuredMayBeLeftOut)
{
  const DamagedCopy copy("csv");
  copy.replace("landmarks.csv", "x,y\n4,0\n0,3\n");
  copy.replace("detections.csv", "t,sensor,bearing_deg,std_bearing_deg\n0.5,lidar,90,1\n");
  const Recording recording = importFolder(copy.path());
  EXPECT_EQ(recording.map.size(), 2U);
  EXPECT_EQ(recording.map[0].id, kNoId);
  const Detection detection = recordsOf<Reading>(recording).at(0).detections.at(0);
  EXPECT_EQ(detection.id, kNoId);
  EXPECT_NEAR(*detection.bearing, kPi / 2, 1e-12);
  EXPECT_FALSE(detection.range);
  copy.replace("detections.csv", "t,sensor,range_m\n0.5,lidar,4\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "detections.csv:1: no column 'std_range_m'");
  copy.replace("detections.csv", "t,sensor\n0.5,lidar\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "detections.csv:2: neither bearing_deg nor range_m");
}

TEST(CsvRecording, MillisecondsAreNoticed)
{
  const DamagedCopy copy("csv");
  copy.replace("detections.csv", "t,sensor,range_m,std_range_m\n60,lidar,4,0.1\n160,lidar,4,0.1\n");
  copy.replace("odometry.csv", "t,v,omega_deg_s\n0,1,0\n50,1,0\n100,1,0\n");
  EXPECT_TRUE(hasNote(importFolder(copy.path()), "are the times in milliseconds?"));
  copy.replace("odometry.csv", "t,v,omega_deg_s\n0,1,0\n50.5,1,0\n");
  EXPECT_FALSE(hasNote(importFolder(copy.path()), "milliseconds"));
  copy.replace("odometry.csv", "t,v,omega_deg_s\n1732300000000,1,0\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()),
                     "odometry.csv:2: time 1732300000000 is too large, expected seconds: divide milliseconds by 1000");
}

TEST(CsvRecording, MistakesInTheOtherFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("csv");
  copy.replace("odometry.csv", "t,v,omega_rad_s\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "odometry.csv:1: unknown column 'omega_rad_s'");
  copy.replace("odometry.csv", "t,x,y\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "odometry.csv:1: no column 'phi_deg'");
  copy.replace("odometry.csv", "t,v,omega_deg_s\n1,0,0\n0,0,0\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "odometry.csv:3: time 0 is before the row above");
  copy.replace("odometry.csv", "t,v,omega_deg_s\n");
  copy.replace("landmarks.csv", "id,x,y,z,category\n1,a,0,0,\n");
  EXPECT_INPUT_ERROR((void)importFolder(copy.path()), "landmarks.csv:2: 'a' is not a number, expected x");
}

TEST(CsvRecording, DirectionsOfLandmarksAreOptional)
{
  const DamagedCopy copy("csv");
  copy.replace("landmarks.csv", "id,x,y,yaw_deg\n1,4,0,180\n");
  const auto facingOf = [&](const std::string& columns, const std::string& fields)
  {
    copy.replace("detections.csv",
                 "t,sensor,id,bearing_deg,std_bearing_deg" + columns + "\n0.5,eye,1,10,1" + fields + "\n");
    const Recording recording = importFolder(copy.path());
    EXPECT_NEAR(*recording.map[0].yaw, kPi, 1e-12);
    return recordsOf<Reading>(recording).at(0).detections.at(0).facing;
  };
  EXPECT_FALSE(facingOf("", ""));
  EXPECT_FALSE(facingOf(",yaw_deg,std_yaw_deg", ",,"));
  const auto one = facingOf(",yaw_deg,std_yaw_deg", ",170,2");
  ASSERT_TRUE(one);
  EXPECT_NEAR(one->attitudes[0].yaw, degToRad(170), 1e-12);
  EXPECT_NEAR(one->attitudes[0].std, degToRad(2), 1e-12);
  EXPECT_EQ(one->attitudes[1].weight, 0);
  const std::string all = ",yaw_deg,std_yaw_deg,other_yaw_deg,other_std_yaw_deg,other_weight";
  const auto either = facingOf(all, ",170,2,150,3,0.2");
  ASSERT_TRUE(either);
  EXPECT_NEAR(either->attitudes[1].yaw, degToRad(150), 1e-12);
  EXPECT_EQ(either->attitudes[1].weight, 0.2);
  EXPECT_EQ(facingOf(all, ",170,2,,,")->attitudes[1].weight, 0);
  EXPECT_INPUT_ERROR((void)facingOf(",yaw_deg", ",170"), "detections.csv:1: no column 'std_yaw_deg'");
  EXPECT_INPUT_ERROR((void)facingOf(",yaw_deg,std_yaw_deg", ",170,"), "detections.csv:2: std_yaw_deg is ''");
  EXPECT_INPUT_ERROR((void)facingOf(all, ",170,2,150,3,"), "detections.csv:2: other_weight is missing");
  EXPECT_INPUT_ERROR((void)facingOf(all, ",,,150,3,0.2"), "detections.csv:2: other_yaw_deg without yaw_deg");
}
}  // namespace mrpt_ext::test_csv_recording
