#include "mrpt_ext/configuration/sensor_sections.h"
#include "mrpt_ext/frames/sensor_config.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_sensor_config
{
namespace
{
using testing::configurationErrorOf;

const LandmarkTable kMap({{.id = 1, .position = {2, 0, 2}, .category = "red"}, {.id = 2, .position = {0, 5, 0}}});

SensorConfigs configsOf(const std::string& keys)
{
  return sensorConfigs(Settings::parse("[Sensor_eye]\n" + keys, "/a/b.ini", localizationKeys()));
}

Reading readingOf(std::vector<Detection> detections)
{
  Reading reading{.time = 10, .sensor = "eye"};
  reading.detections = std::move(detections);
  return reading;
}

/// One detection after the configuration; it must be usable.
Detection configuredDetection(Detection detection, const std::string& keys)
{
  UnusableDetections unusable;
  const Reading reading = configured(readingOf({std::move(detection)}), configsOf(keys), kMap, unusable);
  EXPECT_TRUE(unusable.empty());
  return reading.detections.at(0);
}

const Detection kBoth{.id = 1, .bearing = 0.5, .range = 4, .std_bearing = 0.02, .std_range = 0.1};

/// A scan with one bright beam straight ahead, and one to the left.
RangeScan brightScan()
{
  RangeScan scan;
  scan.time = 10;
  scan.sensor = "eye";
  scan.first_bearing = -0.2;
  scan.bearing_step = 0.1;
  scan.std_range = 0.02;
  scan.ranges = {9, 9, 3, 9, 4};
  scan.intensities = {1, 1, 100, 1, 100};
  return scan;
}
}  // namespace

TEST(SensorConfig, ReflectorsOfAScanAreAReading)
{
  UnusableDetections unusable;
  const auto configs = configsOf(
      "extract = reflectors\nintensity_above = 50\nreflector_diameter_m = 0.2\ndelay_s = 1\nstd_range_m = 0.5\n");
  const auto reading = configured(brightScan(), configs, kMap, unusable);
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->time, 9);
  ASSERT_EQ(reading->detections.size(), 2U);
  EXPECT_NEAR(*reading->detections[0].range, 3.1, 1e-6);
  EXPECT_EQ(reading->detections[0].std_range, 0.5);
  EXPECT_TRUE(unusable.empty());
}

TEST(SensorConfig, ScansThatAreNotUsedAreCounted)
{
  UnusableDetections unusable;
  EXPECT_FALSE(configured(brightScan(), configsOf(""), kMap, unusable));
  RangeScan dark = brightScan();
  dark.intensities.clear();
  EXPECT_FALSE(configured(dark, configsOf("extract = reflectors\nintensity_above = 50\n"), kMap, unusable));
  EXPECT_EQ(unusable, (UnusableDetections{{"eye: laser scan, extract is not set", 1},
                                          {"eye: laser scan without intensities", 1}}));
  EXPECT_NE(configurationErrorOf([] { configsOf("extract = reflectors\n"); }).find("set intensity_above"),
            std::string::npos);
}

TEST(SensorConfig, WithoutASectionEverythingIsAsLogged)
{
  UnusableDetections unusable;
  Reading logged = readingOf({kBoth});
  logged.sensor = "other";
  logged.model.field_of_view = 1;
  logged.model.max_range = 7;
  const Reading reading = configured(logged, configsOf("delay_s = 3\n"), kMap, unusable);
  EXPECT_EQ(reading.time, 10);
  EXPECT_EQ(reading.detections[0].bearing, 0.5);
  EXPECT_EQ(reading.detections[0].range, 4.0);
  EXPECT_EQ(reading.detections[0].std_range, 0.1);
  EXPECT_EQ(reading.detections[0].id, 1);
  EXPECT_EQ(reading.model.field_of_view, 1);
  EXPECT_EQ(reading.model.max_range, 7.0);
  EXPECT_EQ(reading.model.clutter_probability, 0.05);
  EXPECT_FALSE(reading.model.detection_probability);
}

TEST(SensorConfig, DelayBiasAndScaleAreCorrected)
{
  UnusableDetections unusable;
  const SensorConfigs configs =
      configsOf("delay_s = 0.25\nbias_bearing_deg = 10\nbias_range_m = 0.5\nscale_range = 1.25\n");
  const Reading reading = configured(readingOf({kBoth}), configs, kMap, unusable);
  EXPECT_EQ(reading.time, 9.75);
  EXPECT_NEAR(*reading.detections[0].bearing, 0.5 - degToRad(10), 1e-12);
  EXPECT_NEAR(*reading.detections[0].range, 2.8, 1e-12);  // 4 = 1.25 * 2.8 + 0.5
  const Detection turned = configuredDetection({.bearing = -kPi + 0.01, .std_bearing = 0.1}, "bias_bearing_deg = 10\n");
  EXPECT_NEAR(*turned.bearing, kPi + 0.01 - degToRad(10), 1e-12);
  Detection faced = kBoth;
  faced.facing = Facing::single(1, 0.1);
  EXPECT_NEAR(configuredDetection(faced, "bias_bearing_deg = 10\n").facing->attitudes[0].yaw, 1 - degToRad(10), 1e-12);
}

TEST(SensorConfig, ALandmarkMayHaveABiasOfItsOwn)
{
  const std::string keys = "bias_range_m = 0.5\nlandmark_bias_range_m = 2:-0.25 1:0.125\n";
  EXPECT_NEAR(*configuredDetection(kBoth, keys).range, 4 - 0.625, 1e-12);
  EXPECT_NEAR(*configuredDetection(kBoth, keys + "association = anonymous\n").range, 4 - 0.5, 1e-12);
  Detection other = kBoth;
  other.id = 2;
  EXPECT_NEAR(*configuredDetection(other, keys).range, 4 - 0.25, 1e-12);
  EXPECT_EQ(configurationErrorOf([] { (void)configsOf("landmark_bias_range_m = 1:0.1 1:0.2\n"); }),
            "/a/b.ini:2: landmark_bias_range_m = 1:0.1 1:0.2: landmark 1 occurs twice, expected it once");
  for (const char* wrong : {"1", "1:x", "a:1", "1:0.1,2:0.2"})
    EXPECT_NE(configurationErrorOf([&] { (void)configsOf(std::string("landmark_bias_range_m = ") + wrong + "\n"); })
                  .find("expected id:value pairs"),
              std::string::npos)
        << wrong;
}

TEST(SensorConfig, DepthAlongTheAxisBecomesARange)
{
  const Detection corrected =
      configuredDetection(kBoth, "range_along_axis = true\nscale_range = 1.25\nbias_range_m = 0.5\n");
  EXPECT_NEAR(*corrected.range, 2.8 / std::cos(0.5), 1e-12);
  EXPECT_EQ(*corrected.bearing, 0.5);
  const Detection without_bearing{.id = 1, .range = 4, .std_range = 0.1};
  EXPECT_EQ(*configuredDetection(without_bearing, "range_along_axis = true\n").range, 4.0);
}

TEST(SensorConfig, TheAxisOfDepthsIsALoggedBearing)
{
  const Detection corrected = configuredDetection(
      kBoth, "range_along_axis = true\nrange_axis_deg = -2\nbias_bearing_deg = 1\nscale_bearing = 1.25\n");
  EXPECT_NEAR(*corrected.range, 4 / std::cos(0.5 + degToRad(2.0)), 1e-12);
  EXPECT_NEAR(*corrected.bearing, (0.5 - degToRad(1.0)) / 1.25, 1e-12);
  const SensorConfig config{.bias_bearing = degToRad(1.0), .scale_bearing = 1.25};
  EXPECT_NEAR(loggedBearing(*corrected.bearing, config), 0.5, 1e-12);
}

TEST(SensorConfig, DepthOfALandmarkBesideTheSensorIsCountedAsUnusable)
{
  Reading logged{.sensor = "eye", .detections = {kBoth}};
  logged.detections[0].bearing = degToRad(89.0);
  UnusableDetections unusable;
  EXPECT_TRUE(configured(logged, configsOf("range_along_axis = true\n"), kMap, unusable).detections.empty());
  EXPECT_EQ(unusable.at("eye: depth of a landmark that is not ahead"), 1U);
}

TEST(SensorConfig, ConfiguredStdsReplaceLoggedOnesAndGrowWithRange)
{
  EXPECT_NEAR(configuredDetection(kBoth, "std_bearing_deg = 3\n").std_bearing, degToRad(3), 1e-12);
  EXPECT_NEAR(configuredDetection(kBoth, "std_range_m = 0.3\n").std_range, 0.3, 1e-12);
  EXPECT_NEAR(configuredDetection(kBoth, "std_range_m = 0.3\nstd_range_per_m = 0.05\n").std_range, 0.5, 1e-12);
  EXPECT_NEAR(configuredDetection(kBoth, "std_range_per_m = 0.05\n").std_range, 0.3, 1e-12);
  EXPECT_EQ(configuredDetection(kBoth, "std_bearing_deg = 3\n").std_range, 0.1);
}

TEST(SensorConfig, AMissingStdIsAnErrorThatNamesTheKey)
{
  UnusableDetections unusable;
  const auto take = [&](const Detection& detection)
  { (void)configured(readingOf({detection}), configsOf(""), kMap, unusable); };
  EXPECT_EQ(configurationErrorOf([&] { take({.id = 1, .bearing = 0.5}); }),
            "sensor 'eye' logs bearings without a standard deviation, set [Sensor_eye] std_bearing_deg");
  EXPECT_EQ(configurationErrorOf([&] { take({.id = 1, .range = 4}); }),
            "sensor 'eye' logs ranges without a standard deviation, set [Sensor_eye] std_range_m");
  EXPECT_EQ(configurationErrorOf([&] { (void)configured(CompassRecord{.sensor = "eye"}, configsOf("")); }),
            "sensor 'eye' logs headings without a standard deviation, set [Sensor_eye] std_heading_deg");
  RunningFixReading fix{.sensor = "eye", .first_range = 1, .first_std = 0.1, .second_range = 2};
  EXPECT_EQ(configurationErrorOf([&] { (void)configured(fix, configsOf(""), kMap, unusable); }),
            "sensor 'eye' logs ranges without a standard deviation, set [Sensor_eye] std_range_m");
  EXPECT_NEAR(configuredDetection({.id = 1, .range = 4}, "std_range_per_m = 0.05\n").std_range, 0.2, 1e-12);
}

TEST(SensorConfig, TheSensorModelIsReplacedWhereConfigured)
{
  UnusableDetections unusable;
  const SensorConfigs configs = configsOf(
      "field_of_view_deg = 90\nmax_range_m = 8\nclutter_probability = 0.2\ndetection_probability = "
      "0.7\nlever_arm_std_m = 0.02\ndelay_std_s = 0.01\nyaw_std_deg = 2\n");
  const SensorModel model = configured(readingOf({}), configs, kMap, unusable).model;
  EXPECT_NEAR(model.field_of_view, kPi / 2, 1e-12);
  EXPECT_TRUE(model.has_field_of_view);
  EXPECT_EQ(model.max_range, 8.0);
  EXPECT_EQ(model.clutter_probability, 0.2);
  EXPECT_EQ(model.detection_probability, 0.7);
  EXPECT_EQ(model.lever_arm_std, 0.02);
  EXPECT_EQ(model.delay_std, 0.01);
  EXPECT_NEAR(model.yaw_std, degToRad(2.0), 1e-12);
  EXPECT_FALSE(configured(readingOf({}), {}, kMap, unusable).model.has_field_of_view);
}

TEST(SensorConfig, TheLeverArmIsAddedToTheLoggedPlace)
{
  UnusableDetections unusable;
  const SensorConfigs configs = configsOf("lever_arm_x_m = 0.1\nlever_arm_y_m = -0.2\n");
  Reading reading = readingOf({});
  reading.T_robot_sensor = {1, 2, 0.5};
  const Pose2 place = configured(reading, configs, kMap, unusable).T_robot_sensor;
  EXPECT_NEAR(place.x, 1.1, 1e-12);
  EXPECT_NEAR(place.y, 1.8, 1e-12);
  EXPECT_EQ(place.phi, 0.5);
  const RunningFixReading fix{.sensor = "eye",
                              .T_robot_sensor = {1, 2, 0.5},
                              .id = 1,
                              .first_range = 3,
                              .first_std = 0.1,
                              .second_range = 3,
                              .second_std = 0.1};
  const auto moved = configured(fix, configs, kMap, unusable);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->T_robot_sensor.x, 1.1, 1e-12);
}

TEST(SensorConfig, AssociationLimitsTheIdentityThatIsUsed)
{
  EXPECT_EQ(configuredDetection(kBoth, "association = known\n").id, 1);
  const Detection category = configuredDetection(kBoth, "association = category\n");
  EXPECT_EQ(category.id, kNoId);
  EXPECT_EQ(category.category, "red");  // of landmark 1
  Detection coloured = kBoth;
  coloured.category = "blue";
  EXPECT_EQ(configuredDetection(coloured, "association = category\n").category, "blue");  // as logged
  const Detection anonymous = configuredDetection(coloured, "association = anonymous\n");
  EXPECT_EQ(anonymous.id, kNoId);
  EXPECT_EQ(anonymous.category, "");
}

TEST(SensorConfig, UnusableDetectionsAreRemovedAndCounted)
{
  UnusableDetections unusable;
  const Reading reading = configured(readingOf({kBoth,
                                                {.id = 9, .bearing = 1.0, .std_bearing = 0.1},
                                                {.id = 9, .bearing = 2.0, .std_bearing = 0.1},
                                                {.id = 2, .range = 0.0, .std_range = 0.1},
                                                {.id = 2, .range = -3.0, .std_range = 0.1},
                                                {.id = 1, .range = 1.9, .std_range = 0.1}}),
                                     {}, kMap, unusable);
  EXPECT_EQ(reading.detections.size(), 1u);
  EXPECT_EQ(unusable, (UnusableDetections{{"eye: id not in the map", 2},
                                          {"eye: range not above zero", 2},
                                          {"eye: slant range shorter than the height difference", 1}}));
  // An id that is not used cannot be wrong; a horizontal range cannot be too short.
  EXPECT_EQ(configuredDetection({.id = 9, .bearing = 1.0, .std_bearing = 0.1}, "association = anonymous\n").id, kNoId);
  Reading flat = readingOf({{.id = 1, .range = 1.9, .std_range = 0.1}});
  flat.horizontal_range = true;
  EXPECT_EQ(configured(flat, {}, kMap, unusable).detections.size(), 1u);
}

TEST(SensorConfig, ARangeShorterThanTheHeightDifferenceLeavesTheBearing)
{
  Detection overhead = kBoth;
  overhead.range = 1.9;  // two metres below landmark 1
  UnusableDetections unusable;
  const Reading reading = configured(readingOf({overhead, kBoth}), {}, kMap, unusable);
  ASSERT_EQ(reading.detections.size(), 2u);
  EXPECT_FALSE(reading.detections[0].range);
  EXPECT_EQ(reading.detections[0].bearing, 0.5);
  EXPECT_EQ(reading.detections[0].id, 1);
  EXPECT_EQ(reading.detections[1].range, 4.0);
  EXPECT_EQ(unusable,
            (UnusableDetections{{"eye: slant range shorter than the height difference, the bearing is used", 1}}));
}

TEST(SensorConfig, RunningFixesAndCompassesAreCorrectedAlike)
{
  UnusableDetections unusable;
  RunningFixReading fix{.time = 10, .first_time = 8, .sensor = "eye", .id = 2, .first_range = 4, .first_std = 0.1};
  fix.second_range = 2.5;
  fix.second_std = 0.2;
  fix.second_bearing = 0.5;
  fix.second_bearing_std = 0.02;
  fix = configured(fix, configsOf("delay_s = 1\nbias_range_m = 0.5\nscale_range = 2\nbias_bearing_deg = 10\n"), kMap,
                   unusable)
            .value();
  EXPECT_EQ(fix.time, 9);
  EXPECT_EQ(fix.first_time, 7);
  EXPECT_NEAR(fix.first_range, 1.75, 1e-12);
  EXPECT_NEAR(fix.second_range, 1, 1e-12);
  EXPECT_NEAR(*fix.second_bearing, 0.5 - degToRad(10), 1e-12);
  const CompassRecord compass = configured(CompassRecord{5, "eye", 0.3, 0},
                                           configsOf("delay_s = 1\nbias_bearing_deg = 10\nstd_heading_deg = 2\n"));
  EXPECT_EQ(compass.time, 4);
  EXPECT_NEAR(compass.heading, 0.3 - degToRad(10), 1e-12);
  EXPECT_NEAR(compass.std_heading, degToRad(2), 1e-12);
}

TEST(SensorConfig, UnusableRunningFixesAreCounted)
{
  RunningFixReading good{.sensor = "eye", .id = 1, .first_range = 4, .first_std = 0.1};
  good.second_range = 3;
  good.second_std = 0.1;
  UnusableDetections unusable;
  EXPECT_TRUE(configured(good, {}, kMap, unusable));
  EXPECT_TRUE(unusable.empty());
  RunningFixReading stranger = good, backwards = good, low = good;
  stranger.id = 9;
  backwards.first_range = -1;
  low.second_range = 1.9;  // two metres below landmark 1
  for (const RunningFixReading& fix : {stranger, backwards, low}) EXPECT_FALSE(configured(fix, {}, kMap, unusable));
  EXPECT_FALSE(configured(good, configsOf("association = anonymous\n"), kMap, unusable));
  EXPECT_EQ(unusable, (UnusableDetections{{"eye: id not in the map", 1},
                                          {"eye: range not above zero", 1},
                                          {"eye: running fix, not identified", 1},
                                          {"eye: slant range shorter than the height difference", 1}}));
  low.horizontal_range = true;
  EXPECT_TRUE(configured(low, {}, kMap, unusable));
}

TEST(SensorConfig, EverySectionIsASensor)
{
  const SensorConfigs configs =
      sensorConfigs(Settings::parse("[Sensor_a]\nignore = true\n[Sensor_b]\n", "/a/b.ini", localizationKeys()));
  ASSERT_EQ(configs.size(), 2u);
  EXPECT_TRUE(configs.at("a").ignore);
  EXPECT_FALSE(configs.at("b").ignore);
}
TEST(SensorConfig, BearingsAreCorrectedForOffsetAndScale)
{
  const Detection d = configuredDetection(kBoth, "bias_bearing_deg = -1.5\nscale_bearing = 1.04\n");
  EXPECT_NEAR(*d.bearing, (0.5 + degToRad(1.5)) / 1.04, 1e-12);
}

TEST(SensorConfig, ALabelInheritsFromTheOneItContinues)
{
  const SensorConfigs configs = sensorConfigs(
      Settings::parse("[Sensor_eye]\nscale_range = 1.1\nbias_range_m = 0.5\n[Sensor_eye.2]\nscale_range = 1.2\n",
                      "/a/b.ini", localizationKeys()));
  EXPECT_EQ(configOf(configs, "eye.2").scale_range, 1.2);
  EXPECT_EQ(configOf(configs, "eye.2").bias_range, 0.5);
  EXPECT_EQ(configOf(configs, "eye.3").scale_range, 1.1);  // no section of its own
  EXPECT_EQ(configOf(configs, "eye").scale_range, 1.1);
  EXPECT_EQ(configOf(configs, "eyelid").scale_range, 1.0);
}
}  // namespace mrpt_ext::test_sensor_config
