#include "mrpt_ext/simulation/sensor_simulator.h"

#include <gtest/gtest.h>

#include <set>

namespace mrpt_ext::test_sensor_simulator
{
namespace
{
constexpr int kReadings = 20000;

double perReading(std::size_t count) { return static_cast<double>(count) / kReadings; }

struct Moments
{
  double mean = 0, std = 0;
};

Moments momentsOf(const std::vector<double>& values)
{
  Moments moments;
  for (const double v : values) moments.mean += v / static_cast<double>(values.size());
  for (const double v : values) moments.std += square(v - moments.mean) / static_cast<double>(values.size());
  moments.std = std::sqrt(moments.std);
  return moments;
}

std::vector<SceneFeature> oneLandmark() { return {{7, "pole", {3, 4, 1}, true}}; }

std::vector<Detection> manyDetections(const SimulatedSensor& sensor, const std::vector<SceneFeature>& features)
{
  RandomStream random(21);
  std::vector<Detection> detections;
  for (int i = 0; i < kReadings; ++i)
    for (const Detection& d : simulateReading(sensor, {}, features, random).detections) detections.push_back(d);
  return detections;
}

SimulatedSensor rangeBearing()
{
  SimulatedSensor sensor;
  sensor.std_bearing = 0;
  sensor.label = "camera";
  sensor.kind = SensorKind::range_bearing;
  sensor.height = 1;
  return sensor;
}
}  // namespace

TEST(VisibleFeatures, RespectPoseFieldOfViewAndRange)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.T_robot_sensor = {1, 0, kPi / 2};
  sensor.height = 0;
  sensor.field_of_view = degToRad(90);
  sensor.max_range = 5;
  sensor.min_range = 0.5;
  const std::vector<SceneFeature> features{{1, "", {1, 3, 4}, true},   {2, "", {1, -3, 0}, true},
                                           {3, "", {1, 6, 0}, true},   {4, "", {1, 0.4, 0}, true},
                                           {5, "", {3.9, 3, 0}, true}, {6, "", {4.1, 3, 0}, true}};
  const auto visible = visibleFeatures(sensor, {0, 0, 0}, features);
  ASSERT_EQ(visible.size(), 2U);
  EXPECT_EQ(visible[0].feature, 0U);
  EXPECT_NEAR(visible[0].bearing, 0, 1e-12);
  EXPECT_NEAR(visible[0].range, 5, 1e-12);
  EXPECT_EQ(visible[1].feature, 4U);
  sensor.horizontal_range = true;
  EXPECT_NEAR(visibleFeatures(sensor, {0, 0, 0}, features)[0].range, 3, 1e-12);
}

TEST(VisibleFeatures, AreHiddenByNearerOnesWithARadius)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.field_of_view = kTwoPi;
  const SceneFeature post{kNoId, "", {2, 0.3, 0}, false, 0.2};
  const std::vector<SceneFeature> features{{1, "", {4, 0.6, 0}},   // behind the post
                                           {2, "", {4, 0.1, 0}},   // beside it
                                           {3, "", {1, 0.15, 0}},  // before it
                                           {4, "", {-4, -0.6, 0}},
                                           post};
  std::vector<std::size_t> visible;
  for (const VisibleFeature& feature : visibleFeatures(sensor, {0, 0, 0}, features)) visible.push_back(feature.feature);
  EXPECT_EQ(visible, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST(SimulateReading, NoiseAndBiasComeOutAsConfigured)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.std_bearing = 0.02;
  sensor.bias_bearing = 0.01;
  sensor.std_range = 0.03;
  sensor.std_range_per_m = 0.008;
  sensor.bias_range = 0.1;
  sensor.scale_range = 1.02;
  std::vector<double> bearings, ranges;
  for (const Detection& d : manyDetections(sensor, oneLandmark()))
  {
    bearings.push_back(*d.bearing);
    ranges.push_back(*d.range);
    EXPECT_EQ(d.std_bearing, 0.02);
    EXPECT_NEAR(d.std_range, 0.05, 0.005);
  }
  ASSERT_EQ(bearings.size(), std::size_t{kReadings});
  EXPECT_NEAR(momentsOf(bearings).mean, std::atan2(4, 3) + 0.01, 6e-4);
  EXPECT_NEAR(momentsOf(bearings).std, 0.02, 5e-4);
  EXPECT_NEAR(momentsOf(ranges).mean, 5 * 1.02 + 0.1, 1.5e-3);
  EXPECT_NEAR(momentsOf(ranges).std, 0.05, 1.2e-3);
}

TEST(SimulateReading, StereoNoiseGrowsWithTheSquareOfTheRange)
{
  const double direction = std::atan(0.5);
  for (const double field_of_view : {degToRad(120), kTwoPi})
    for (const double depth : {1.0, 2.0})
    {
      SimulatedSensor sensor = rangeBearing();
      sensor.field_of_view = field_of_view;
      sensor.horizontal_range = true;
      sensor.baseline_focal = 50;
      sensor.std_disparity = 0.25;
      std::vector<double> ranges, declared;
      for (const Detection& d : manyDetections(sensor, {{1, "", {depth, 0.5 * depth, 0}, true}}))
      {
        ranges.push_back(*d.range);
        declared.push_back(d.std_range);
      }
      const double range = depth / std::cos(direction);
      const double depth_share = field_of_view < kPi ? std::cos(direction) : 1;
      const double expected = square(range) * depth_share * 0.25 / 50;
      EXPECT_NEAR(momentsOf(ranges).mean, range, 0.05 * expected);
      EXPECT_NEAR(momentsOf(ranges).std, expected, 0.03 * expected);
      EXPECT_NEAR(momentsOf(declared).mean, expected, 0.03 * expected);
    }
}

TEST(SimulateReading, DetectionProbabilityComesOutAsConfigured)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.detection_probability = 0.8;
  EXPECT_NEAR(perReading(manyDetections(sensor, oneLandmark()).size()), 0.8, 0.012);
}

TEST(SimulateReading, ClutterRateComesOutAsConfiguredAndFillsTheView)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.field_of_view = 2;
  sensor.max_range = 4;
  sensor.clutter_per_reading = 0.3;
  std::vector<double> bearings, ranges;
  for (const Detection& d : manyDetections(sensor, {}))
  {
    bearings.push_back(*d.bearing);
    ranges.push_back(*d.range);
    ASSERT_LE(std::abs(*d.bearing), 1);
    ASSERT_LE(*d.range, 4);
  }
  EXPECT_NEAR(perReading(bearings.size()), 0.3, 0.016);
  EXPECT_NEAR(momentsOf(bearings).std, 1 / std::sqrt(3), 0.02);
  EXPECT_NEAR(momentsOf(ranges).mean, 2, 0.06);
}

TEST(SimulateReading, ReportsNoMoreThanItsIdentityLevel)
{
  SimulatedSensor sensor = rangeBearing();
  RandomStream random(1);
  std::vector<SceneFeature> features = oneLandmark();
  features.push_back({kNoId, "ball", {1, 0, 0}, false});
  std::set<std::pair<int, std::string>> known, category, anonymous;
  for (auto [identity, names] : {std::pair{IdentityLevel::known, &known},
                                 {IdentityLevel::category, &category},
                                 {IdentityLevel::anonymous, &anonymous}})
  {
    sensor.identity = identity;
    for (const Detection& d : simulateReading(sensor, {}, features, random).detections)
      names->insert({d.id, d.category});
  }
  using Names = std::set<std::pair<int, std::string>>;
  EXPECT_EQ(known, (Names{{7, "pole"}, {kNoId, "ball"}}));
  EXPECT_EQ(category, (Names{{kNoId, "pole"}, {kNoId, "ball"}}));
  EXPECT_EQ(anonymous, (Names{{kNoId, ""}}));
  sensor.sees_objects = false;
  EXPECT_EQ(simulateReading(sensor, {}, features, random).detections.size(), 1U);
}

TEST(SimulateReading, WrongIdentitiesComeOutAsConfigured)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.wrong_identity_probability = 0.2;
  sensor.field_of_view = kPi;
  const std::vector<SceneFeature> features{{7, "", {3, 0, 0}, true}, {8, "", {-3, 0, 0}, true}};
  int wrong = 0;
  for (const Detection& d : manyDetections(sensor, features)) wrong += d.id == 8;
  EXPECT_NEAR(wrong / double{kReadings}, 0.2, 0.012);
}

TEST(SimulateReading, LargestNumberOfDetectionsIsAFairChoice)
{
  SimulatedSensor sensor = rangeBearing();
  sensor.max_detections = 2;
  std::vector<SceneFeature> features;
  for (int id = 0; id < 5; ++id) features.push_back({id, "", {std::cos(id), std::sin(id), 0}, true});
  std::vector<int> counts(5);
  const auto detections = manyDetections(sensor, features);
  for (const Detection& d : detections) ++counts.at(static_cast<std::size_t>(d.id));
  EXPECT_EQ(detections.size(), 2U * kReadings);
  for (const int count : counts) EXPECT_NEAR(count, 0.4 * kReadings, 0.02 * kReadings);
}

TEST(SimulateReading, OrderDoesNotIdentifyTheLandmarks)
{
  SimulatedSensor sensor = rangeBearing();
  const std::vector<SceneFeature> features{{1, "", {1, 0, 0}, true}, {2, "", {0, 1, 0}, true}};
  RandomStream random(2);
  int in_map_order = 0;
  for (int i = 0; i < kReadings; ++i)
    in_map_order += simulateReading(sensor, {}, features, random).detections.front().id == 1;
  EXPECT_NEAR(in_map_order / double{kReadings}, 0.5, 0.015);
}

TEST(SimulateReading, KindDecidesWhatIsMeasured)
{
  RandomStream random(1);
  SimulatedSensor sensor = rangeBearing();
  sensor.kind = SensorKind::bearings;
  const Detection bearing = simulateReading(sensor, {}, oneLandmark(), random).detections.at(0);
  EXPECT_TRUE(bearing.bearing && !bearing.range);
  sensor.kind = SensorKind::ranges;
  const Detection range = simulateReading(sensor, {}, oneLandmark(), random).detections.at(0);
  EXPECT_TRUE(range.range && !range.bearing);
}

TEST(SimulateCompass, NoiseAndBiasComeOutAsConfigured)
{
  SimulatedSensor sensor;
  sensor.std_heading = 0.05;
  sensor.bias_heading = -0.02;
  RandomStream random(3);
  std::vector<double> errors;
  for (int i = 0; i < kReadings; ++i)
    errors.push_back(wrap(simulateCompass(sensor, {0, 0, kPi}, random).heading - kPi));
  EXPECT_NEAR(momentsOf(errors).mean, -0.02, 0.0015);
  EXPECT_NEAR(momentsOf(errors).std, 0.05, 0.001);
}
}  // namespace mrpt_ext::test_sensor_simulator
