#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <thread>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/maps/CLandmarkMap2D.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationRunningFix.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/mrpt_scene.h"
#include "mrpt_ext/observations/observation_conversions.h"

namespace mrpt_ext::test_landmark_map
{
namespace
{
const Pose2 kTruth{2.0, 1.5, 0.4};
const Pose2 kMount{0.2, 0.1, 0.3};

LandmarkTable room()
{
  return LandmarkTable({{.id = 1, .position = {0, 0, 0.5}, .category = "pole"},
                        {.id = 2, .position = {6, 0, 0.5}, .category = "pole"},
                        {.id = 3, .position = {5, 4, 0.5}, .category = "post"},
                        {.id = 4, .position = {-1, 3, 0.5}, .category = "post", .stddev = {0.02, 0.03}}});
}

enum class IdentityLevel
{
  known,
  category,
  anonymous
};

/// What a sensor at kMount sees from kTruth, without noise.
Reading perfectReading(IdentityLevel identity, bool bearings, bool ranges)
{
  Reading reading{.sensor = "sensor", .T_robot_sensor = kMount, .sensor_height = 0.5};
  const Pose2 sensor = compose(kTruth, kMount);
  const LandmarkTable landmarks = room();
  for (const Landmark& landmark : landmarks.all())
  {
    const Vector2d offset = landmark.position.head<2>() - sensor.position();
    Detection d{.std_bearing = 0.03, .std_range = 0.1};
    if (identity == IdentityLevel::known) d.id = landmark.id;
    if (identity == IdentityLevel::category) d.category = landmark.category;
    if (bearings) d.bearing = wrap(std::atan2(offset.y(), offset.x()) - sensor.phi);
    if (ranges) d.range = offset.norm();
    reading.detections.push_back(d);
  }
  return reading;
}

mrpt::obs::CObservationBearingRange perfectBearingRange()
{
  mrpt::obs::CObservationBearingRange observation;
  observation.sensorLocationOnRobot = mrpt::poses::CPose3D(kMount.x, kMount.y, 0.5, kMount.phi, 0, 0);
  observation.sensor_std_range = 0.1F;
  observation.sensor_std_yaw = 0.03F;
  for (const Detection& d : perfectReading(IdentityLevel::known, true, true).detections)
    observation.sensedData.push_back({.range = static_cast<float>(*d.range),
                                      .yaw = static_cast<float>(*d.bearing),
                                      .pitch = 0,
                                      .landmarkID = d.id,
                                      .covariance = {}});
  return observation;
}

mrpt::obs::CObservationBeaconRanges perfectBeaconRanges()
{
  mrpt::obs::CObservationBeaconRanges observation;
  observation.stdError = 0.1F;
  observation.maxSensorDistance = 0;  // not declared, as in perfectReading()
  for (const Detection& d : perfectReading(IdentityLevel::known, false, true).detections)
  {
    mrpt::obs::CObservationBeaconRanges::TMeasurement measurement;
    measurement.sensorLocationOnRobot = {kMount.x, kMount.y, 0.5};
    measurement.sensedDistance = static_cast<float>(*d.range);
    measurement.beaconID = d.id;
    observation.sensedData.push_back(measurement);
  }
  return observation;
}

CObservationRunningFix::Ptr perfectFix()
{
  const Pose2 first = compose(kTruth, inverse(Pose2{0.8, 0.3, 0.5}));
  const auto rangeFrom = [](const Pose2& robot)
  { return (room()[1].position.head<2>() - compose(robot, kMount).position()).norm(); };
  return toObservation(RunningFixReading{.time = 2,
                                         .first_time = 1,
                                         .sensor = "goal",
                                         .T_robot_sensor = kMount,
                                         .sensor_height = 0.5,
                                         .id = 2,
                                         .first_range = rangeFrom(first),
                                         .first_std = 0.05,
                                         .second_range = rangeFrom(kTruth),
                                         .second_std = 0.05,
                                         .displacement = {0.8, 0.3, 0.5},
                                         .displacement_covariance = 1e-4 * Matrix3d::Identity()});
}

double score(const CLandmarkMap2D& map, const mrpt::obs::CObservation& observation, const Pose2& robot)
{
  return map.computeObservationLikelihood(observation, mrpt::poses::CPose3D(robot.x, robot.y, 0, robot.phi, 0, 0));
}

/// The truth scores at least as well as poses anywhere else, and much better than most of them.
void expectTruthScoresBest(const mrpt::obs::CObservation& observation)
{
  const CLandmarkMap2D map(room());
  ASSERT_TRUE(map.canComputeObservationLikelihood(observation));
  const double at_truth = score(map, observation, kTruth);
  RandomStream random(7);
  int clearly_worse = 0;
  constexpr int kTrials = 500;
  for (int i = 0; i < kTrials; ++i)
  {
    const double elsewhere =
        score(map, observation, {random.uniform(-2, 7), random.uniform(-1, 5), random.uniform(-kPi, kPi)});
    ASSERT_TRUE(std::isfinite(elsewhere));
    EXPECT_LE(elsewhere, at_truth + 1e-9);
    clearly_worse += elsewhere < at_truth - 3 ? 1 : 0;
  }
  EXPECT_GT(clearly_worse, kTrials * 8 / 10);
}
}  // namespace

TEST(LandmarkMap, TheTruePoseScoresBestForEveryClassAndIdentity)
{
  for (const IdentityLevel identity : {IdentityLevel::known, IdentityLevel::category, IdentityLevel::anonymous})
  {
    SCOPED_TRACE(static_cast<int>(identity));
    expectTruthScoresBest(*toLandmarkBearings(perfectReading(identity, true, false)));
    expectTruthScoresBest(*toStereoRanges(perfectReading(identity, false, true)));
    expectTruthScoresBest(*toStereoRanges(perfectReading(identity, true, true)));
  }
  expectTruthScoresBest(perfectBearingRange());
  expectTruthScoresBest(perfectBeaconRanges());
  expectTruthScoresBest(*perfectFix());
}

TEST(LandmarkMap, BothClassesScoreTheSame)
{
  const CLandmarkMap2D map(room());
  const Pose2 elsewhere{2.3, 1.2, 0.5};
  EXPECT_NEAR(score(map, perfectBearingRange(), elsewhere),
              score(map, *toStereoRanges(perfectReading(IdentityLevel::known, true, true)), elsewhere), 1e-3);
  EXPECT_NEAR(score(map, perfectBeaconRanges(), elsewhere),
              score(map, *toStereoRanges(perfectReading(IdentityLevel::known, false, true)), elsewhere), 1e-3);
}

TEST(LandmarkMap, ScoresStayFiniteForDamagedOrStrangeObservations)
{
  const CLandmarkMap2D map(room());
  for (const double value :
       {0.0, -1.0, 1e-300, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
  {
    Reading reading = perfectReading(IdentityLevel::anonymous, true, true);
    reading.detections[0].range = value;
    reading.detections[1].bearing = value;
    reading.detections[2].std_bearing = value;
    reading.detections[3].std_range = value;
    EXPECT_TRUE(std::isfinite(score(map, *toStereoRanges(reading), kTruth))) << value;
    EXPECT_TRUE(std::isfinite(score(map, *toStereoRanges(reading), {1e12, -1e12, 3}))) << value;
  }
}

TEST(LandmarkMap, AnEmptyMapScoresEveryPoseTheSame)
{
  const CLandmarkMap2D map;
  const auto observation = toLandmarkBearings(perfectReading(IdentityLevel::anonymous, true, false));
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(score(map, *observation, kTruth), score(map, *observation, {0, 0, 0}));
}

TEST(LandmarkMap, RejectsClassesThatItCannotScore)
{
  CLandmarkMap2D map(room());
  const mrpt::obs::CObservationComment comment;
  EXPECT_FALSE(map.canComputeObservationLikelihood(comment));
  EXPECT_FALSE(map.insertObservation(perfectBeaconRanges()));
  EXPECT_EQ(map.landmarks().size(), room().size());
}

TEST(LandmarkMap, StdsThatTheLogDoesNotDeclareComeFromTheOptions)
{
  Reading reading = perfectReading(IdentityLevel::known, true, false);
  for (Detection& d : reading.detections) d.std_bearing = 0;
  CLandmarkMap2D narrow(room()), wide(room());
  narrow.likelihood_options.default_std_bearing = 0.01;
  wide.likelihood_options.default_std_bearing = 0.2;
  const Pose2 near{2.2, 1.5, 0.4};
  const auto observation = toLandmarkBearings(reading);
  EXPECT_GT(score(narrow, *observation, kTruth), score(wide, *observation, kTruth));
  EXPECT_LT(score(narrow, *observation, near), score(wide, *observation, near));
}

TEST(LandmarkMap, MayBeScoredInSeveralThreadsAtOnce)
{
  const CLandmarkMap2D map(room());
  const auto observation = toLandmarkBearings(perfectReading(IdentityLevel::anonymous, true, false));
  const auto scoreMany = [&](std::vector<double>& scores)
  {
    for (int i = 0; i < 300; ++i) scores.push_back(score(map, *observation, {0.01 * i, 1, 0.02 * i}));
  };
  std::vector<double> alone;
  scoreMany(alone);
  std::vector<std::vector<double>> together(4);
  std::vector<std::thread> threads;
  for (auto& scores : together) threads.emplace_back([&] { scoreMany(scores); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& scores : together) EXPECT_EQ(scores, alone);
}

TEST(LandmarkMap, SurvivesSerialization)
{
  registerAllClasses();
  CLandmarkMap2D map(room());
  map.likelihood_options.clutter_probability = 0.2;
  map.likelihood_options.detection_probability = 0.7;
  map.likelihood_options.default_std_bearing = 0.07;
  map.likelihood_options.default_std_range = 0.3;
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << map;
  stream.Seek(0);
  const auto copy = std::dynamic_pointer_cast<CLandmarkMap2D>(archive.ReadObject());
  ASSERT_TRUE(copy);
  ASSERT_EQ(copy->landmarks().size(), map.landmarks().size());
  for (std::size_t i = 0; i < map.landmarks().size(); ++i)
  {
    EXPECT_EQ(copy->landmarks()[i].id, map.landmarks()[i].id);
    EXPECT_EQ(copy->landmarks()[i].position, map.landmarks()[i].position);
    EXPECT_EQ(copy->landmarks()[i].category, map.landmarks()[i].category);
    EXPECT_EQ(copy->landmarks()[i].stddev, map.landmarks()[i].stddev);
  }
  EXPECT_EQ(copy->likelihood_options.clutter_probability, 0.2);
  EXPECT_EQ(copy->likelihood_options.detection_probability, 0.7);
  EXPECT_EQ(copy->likelihood_options.default_std_bearing, 0.07);
  EXPECT_EQ(copy->likelihood_options.default_std_range, 0.3);
}

TEST(LandmarkMap, ShowsEveryLandmarkWithItsId)
{
  const CLandmarkMap2D map(room());
  scenes::CSetOfObjects scene;
  map.getVisualizationInto(scene);
  EXPECT_EQ(scene.size(), 2 * room().size() + 1);  // a ball and an id each, one of them with an ellipse
}

TEST(LandmarkMap, SavesItselfAsAMapFile)
{
  const std::string prefix = ::testing::TempDir() + "landmark_map_" + std::to_string(getpid());
  CLandmarkMap2D(room()).saveMetricMapRepresentationToFile(prefix);
  const LandmarkTable again = readLandmarkCsv(prefix + "_landmarks.csv");
  ASSERT_EQ(again.size(), room().size());
  EXPECT_EQ(again[3].stddev, room()[3].stddev);
  std::filesystem::remove(prefix + "_landmarks.csv");
}

TEST(LandmarkMap, DirectionsAreKept)
{
  registerAllClasses();
  const CLandmarkMap2D map(
      LandmarkTable({{.id = 1, .position = {1, 2, 3}, .yaw = -2.5, .std_yaw = 0.1}, {.id = 2, .position = {4, 5, 6}}}));
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << map;
  stream.Seek(0);
  const auto copy = std::dynamic_pointer_cast<CLandmarkMap2D>(archive.ReadObject());
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->landmarks()[0].yaw, -2.5);
  EXPECT_EQ(copy->landmarks()[0].std_yaw, 0.1);
  EXPECT_FALSE(copy->landmarks()[1].yaw);
  EXPECT_EQ(copy->landmarks()[1].position, Vector3d(4, 5, 6));
}

TEST(LandmarkMap, TheDirectionOfALandmarkTellsTheHeading)
{
  const CLandmarkMap2D map(LandmarkTable({{.id = 1, .position = {3, 0, 0}, .yaw = kPi}}));
  Reading reading{.sensor = "camera"};
  reading.detections = {{.id = 1, .bearing = 0, .range = 3, .std_bearing = 0.01, .std_range = 0.05}};
  reading.detections[0].facing = Facing::single(kPi, 0.05);
  // Poses on a circle about the landmark see it alike, but for the side.
  const Pose2 truth{0, 0, 0}, elsewhere{3, -3, kPi / 2};
  EXPECT_GT(score(map, *toStereoRanges(reading), truth), score(map, *toStereoRanges(reading), elsewhere) + 3);
  reading.detections[0].facing.reset();
  EXPECT_NEAR(score(map, *toStereoRanges(reading), truth), score(map, *toStereoRanges(reading), elsewhere), 1e-6);
}
}  // namespace mrpt_ext::test_landmark_map
