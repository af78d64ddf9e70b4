#include "mrpt_ext/filter/integrity/sensor_monitors.h"

#include <gtest/gtest.h>

namespace mrpt_ext
{
TEST(SensorMonitors, KindsAreSensorsAndWhatTheyMeasure)
{
  Reading reading{.sensor = "eye"};
  reading.detections = {{.id = 1, .bearing = 0.1}};
  EXPECT_EQ(sensorKey(reading), "eye bearings");
  reading.detections.push_back({.id = 2, .range = 3.0});
  EXPECT_EQ(sensorKey(reading), "eye ranges and bearings");
  reading.detections = {{.id = 2, .range = 3.0}};
  EXPECT_EQ(sensorKey(reading), "eye ranges");
}

TEST(SensorMonitors, ARareSensorIsHeardBesideABusyOne)
{
  InlierRatioMonitor together({});
  SensorMonitors kinds({});
  const auto observe = [&](const std::string& kind, double explained, std::size_t count)
  {
    together.observe(explained, 0.95, count);
    kinds.observe(kind, explained, 0.95, count);
  };
  for (int second = 0; second < 60; ++second)
  {
    observe("radio ranges", 0.95, 20);
    observe("camera bearings", 0.95, 1);
    EXPECT_FALSE(kinds.dropped());
  }
  int alarm_at = 0;
  for (int second = 1; second <= 20; ++second)
  {
    observe("radio ranges", 0.95, 20);
    observe("camera bearings", 0.02, 1);
    if (kinds.dropped() && alarm_at == 0) alarm_at = second;
    EXPECT_FALSE(together.suspicious());
  }
  EXPECT_GT(alarm_at, 4);
  EXPECT_NE(kinds.finding().find("camera bearings explain only"), std::string::npos);
}

TEST(SensorMonitors, ASensorThatNeverAgreedIsNamedAndRaisesNoAlarm)
{
  SensorMonitors kinds({});
  for (int second = 0; second < 100; ++second)
  {
    kinds.observe("camera bearings", 0.1, 0.95, 3);
    kinds.observe("radio ranges", 0.95, 0.95, 3);
    EXPECT_FALSE(kinds.dropped());
  }
  EXPECT_EQ(kinds.finding(), "camera bearings explain only 11 % of what is expected");
}
}  // namespace mrpt_ext
