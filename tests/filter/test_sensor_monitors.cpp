#include "mrpt_ext/filter/integrity/sensor_monitors.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_sensor_monitors
{
TEST(SensorMonitors, KeysAreSensorsAndWhatTheyMeasure)
{
  Reading reading{.sensor = "eye"};
  reading.detections = {{.id = 1, .bearing = 0.1}};
  EXPECT_EQ(sensorKey(reading), "eye bearings");
  reading.detections.push_back({.id = 2, .range = 3.0});
  EXPECT_EQ(sensorKey(reading), "eye ranges and bearings");
  reading.detections = {{.id = 2, .range = 3.0}};
  EXPECT_EQ(sensorKey(reading), "eye ranges");
}

TEST(SensorMonitors, ASlowSensorCountsBesideAFastOne)
{
  InlierRatioMonitor together = InlierRatioMonitor::fast({});
  SensorMonitors sensors({});
  const auto observe = [&](const std::string& sensor, double inliers, std::size_t count)
  {
    together.observe(inliers, 0.95, count);
    sensors.observe(sensor, inliers, 0.95, count);
  };
  for (int second = 0; second < 60; ++second)
  {
    observe("radio ranges", 0.95, 20);
    observe("camera bearings", 0.95, 1);
    EXPECT_FALSE(sensors.dropped());
  }
  int alarm_at = 0;
  for (int second = 1; second <= 20; ++second)
  {
    observe("radio ranges", 0.95, 20);
    observe("camera bearings", 0.02, 1);
    if (sensors.dropped() && alarm_at == 0) alarm_at = second;
    EXPECT_FALSE(together.suspicious());
  }
  EXPECT_GT(alarm_at, 4);
  EXPECT_NE(sensors.finding().find("camera bearings: inlier ratio"), std::string::npos);
}

TEST(SensorMonitors, ASensorThatNeverAgreedIsReportedAndRaisesNoAlarm)
{
  SensorMonitors sensors({});
  for (int second = 0; second < 100; ++second)
  {
    sensors.observe("camera bearings", 0.1, 0.95, 3);
    sensors.observe("radio ranges", 0.95, 0.95, 3);
    EXPECT_FALSE(sensors.dropped());
  }
  EXPECT_EQ(sensors.finding(), "camera bearings: inlier ratio 11 % of the expected value");
}
}  // namespace mrpt_ext::test_sensor_monitors
