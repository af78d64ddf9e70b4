#include "mrpt_ext/simulation/simulated_drive.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "simulated_recording.h"

namespace mrpt_ext::test_simulated_drive
{
namespace
{
using testing::simulate;

Scenario smallWorld()
{
  Scenario scenario;
  scenario.duration = 20;
  scenario.map.layout = MapLayout::random;
  scenario.path.kind = PathKind::circle;
  scenario.path.centre = {5, 5};
  scenario.path.radius = 2;
  scenario.odometry = {.std_xy_per_m = 0, .std_phi_deg_per_deg = 0, .std_phi_deg_per_m = 0};
  SimulatedSensor camera;
  camera.std_bearing = 0;
  camera.label = "omni";
  camera.rate_hz = 4;
  camera.phase_s = 0.03;
  scenario.sensors.push_back(camera);
  return scenario;
}

template <class RecordType>
std::vector<RecordType> all(const Recording& recording)
{
  std::vector<RecordType> found;
  for (const Record& record : recording.records)
    if (const RecordType* one = std::get_if<RecordType>(&record)) found.push_back(*one);
  return found;
}
}  // namespace

TEST(SimulatedDrive, RecordsAreOrderedAndCountFollowsTheRates)
{
  const Recording recording = simulate(smallWorld());
  EXPECT_EQ(all<OdometryRecord>(recording).size(), 201U);
  EXPECT_EQ(all<Reading>(recording).size(), 80U);
  for (std::size_t i = 1; i < recording.records.size(); ++i)
    EXPECT_LE(timeOf(recording.records[i - 1]), timeOf(recording.records[i]));
  EXPECT_DOUBLE_EQ(timeOf(recording.records.front()), 1000);
  EXPECT_EQ(recording.map.size(), 10U);
}

TEST(SimulatedDrive, MeasurementsWithoutErrorsFitTheTruth)
{
  const Recording recording = simulate(smallWorld());
  for (const Reading& reading : all<Reading>(recording))
  {
    const auto truth = interpolate(recording.truth, reading.time, 0.2);
    ASSERT_TRUE(truth);
    for (const Detection& d : reading.detections)
    {
      const Vector2d landmark = recording.map[*recording.map.indexOf(d.id)].position.head<2>();
      EXPECT_NEAR(wrap(*d.bearing - predictBearing(truth->pose, landmark)), 0, 3e-3);
    }
  }
}

TEST(SimulatedDrive, TruthCoversTheWholeRun)
{
  Scenario scenario = smallWorld();
  scenario.duration = 10.05;
  const Trajectory truth = simulate(scenario).truth;
  EXPECT_DOUBLE_EQ(truth.front().time, 1000);
  EXPECT_DOUBLE_EQ(truth.back().time, 1010.05);
  for (std::size_t i = 1; i < truth.size(); ++i) EXPECT_GT(truth[i].time, truth[i - 1].time);
}

TEST(SimulatedDrive, KidnappingMovesTheRobotButNotItsOdometry)
{
  Scenario scenario = smallWorld();
  const auto before = all<OdometryRecord>(simulate(scenario));
  scenario.kidnappings = {{8.05, {1, 2, 0.5}}, {15.05, {9, 9, -1}}};
  const Recording recording = simulate(scenario);
  const auto after = all<OdometryRecord>(recording);
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i].pose.x, before[i].pose.x);
  const auto at = [&](double t) { return interpolate(recording.truth, 1000 + t, 0.2)->pose; };
  EXPECT_NEAR(at(8.1).x, 1 + 0.05 * 0.3 * std::cos(0.5), 1e-3);
  EXPECT_NEAR(at(8.1).y, 2 + 0.05 * 0.3 * std::sin(0.5), 1e-3);
  EXPECT_NEAR((at(15.1).position() - Vector2d(9, 9)).norm(), 0.015, 1e-3);
  EXPECT_GT((at(8.0).position() - at(8.1).position()).norm(), 3);
}

TEST(SimulatedDrive, SameSeedSameRecordsAndStreamsAreSeparate)
{
  Scenario scenario = smallWorld();
  scenario.sensors[0].std_bearing = 0.01;
  scenario.odometry.std_xy_per_m = 0.05;
  const auto firstBearing = [](const Recording& r) { return *all<Reading>(r).front().detections.front().bearing; };
  const Recording a = simulate(scenario), b = simulate(scenario);
  EXPECT_EQ(firstBearing(a), firstBearing(b));
  EXPECT_EQ(a.truth.back().pose.x, b.truth.back().pose.x);

  scenario.odometry.std_xy_per_m = 0.2;
  scenario.sensors.push_back(scenario.sensors[0]);
  const Recording noisier = simulate(scenario);
  EXPECT_EQ(firstBearing(a), firstBearing(noisier));
  EXPECT_NE(all<OdometryRecord>(a).back().pose.x, all<OdometryRecord>(noisier).back().pose.x);

  scenario.random_seed = 2;
  EXPECT_NE(firstBearing(noisier), firstBearing(simulate(scenario)));
}

TEST(SimulatedDrive, ObjectsAreSeenWhereTheyAre)
{
  Scenario scenario = smallWorld();
  scenario.map.layout = MapLayout::given;
  SimulatedObject ball;
  ball.category = "ball";
  ball.path.kind = PathKind::waypoints;
  ball.path.waypoints = {{0, 0}, {1, 0}};
  ball.path.closed = false;
  ball.path.speed = 0.1;
  scenario.objects.push_back(ball);
  const Recording recording = simulate(scenario);
  const Reading last = all<Reading>(recording).back();
  ASSERT_EQ(last.detections.size(), 1U);
  EXPECT_EQ(last.detections[0].category, "ball");
  EXPECT_EQ(last.detections[0].id, kNoId);
  const Pose2 robot = interpolate(recording.truth, last.time, 0.2)->pose;
  EXPECT_NEAR(wrap(*last.detections[0].bearing - predictBearing(robot, {1, 0})), 0, 2e-3);
  EXPECT_TRUE(recording.map.empty());
}

TEST(SimulatedDrive, CompassAndRunningFixesAreLogged)
{
  Scenario scenario = smallWorld();
  SimulatedSensor compass;
  compass.label = "compass";
  compass.kind = SensorKind::compass;
  SimulatedSensor fixes;
  fixes.label = "stereo";
  fixes.kind = SensorKind::running_fix;
  scenario.sensors = {compass, fixes};
  const Recording recording = simulate(scenario);
  EXPECT_EQ(all<CompassRecord>(recording).size(), 101U);
  ASSERT_GT(all<RunningFixReading>(recording).size(), 20U);
  EXPECT_TRUE(all<Reading>(recording).empty());
  EXPECT_GT(all<RunningFixReading>(recording).front().first_time, 999);
}

TEST(SimulatedDrive, ASpinningScannerSeesEachLandmarkFromWhereTheRobotWasThen)
{
  Scenario scenario = smallWorld();
  SimulatedSensor& scanner = scenario.sensors.front();
  scanner.sweep = {.duration = 0.4, .direction = SweepDirection::clockwise};
  scenario.path.speed = 2;
  const Recording recording = simulate(scenario);
  const std::vector<Reading> readings = all<Reading>(recording);
  const Reading& reading = readings.at(readings.size() / 2);
  ASSERT_EQ(reading.detections.size(), recording.map.size());
  for (const Detection& d : reading.detections)
  {
    const Pose2 then = interpolate(recording.truth, reading.time - scanner.sweep.ageOf(*d.bearing, kTwoPi), 1)->pose;
    const Vector2d landmark = recording.map[*recording.map.indexOf(d.id)].position.head<2>();
    EXPECT_NEAR(wrap(*d.bearing - predictBearing(then, landmark)), 0, 2e-3);
  }
}
}  // namespace mrpt_ext::test_simulated_drive
