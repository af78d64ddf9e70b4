#include "mrpt_ext/localizers/windowed_localizer.h"

#include <gtest/gtest.h>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_windowed_localizer
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const ExactSensor kSensor{.range = true, .T_robot_sensor = {0.3, -0.2, 0.7}};

/// Records its input.
class Recorder : public Localizer
{
 public:
  explicit Recorder(Frame& recorded) : recorded_(recorded) {}
  [[nodiscard]] std::string name() const override { return "recorder"; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override
  {
    recorded_ = frame;
    return {.status = SolveStatus::none};
  }

 private:
  Frame& recorded_;
};
}  // namespace

TEST(WindowedLocalizer, PassesTheReadingsOfTheWindowToTheMethod)
{
  Frame recorded;
  WindowedLocalizer localizer(std::make_unique<Recorder>(recorded), 5, MotionModel{});
  EXPECT_EQ(localizer.name(), "recorder_joined");
  EXPECT_FALSE(localizer.continuous());
  Frame first{.time = 0, .readings = {seenFrom({}, kMap, {0}, kSensor)}};
  first.compass = CompassRecord{.heading = 1};
  EXPECT_EQ(localizer.process(first).status, SolveStatus::none);
  EXPECT_TRUE(recorded.compass);
  (void)localizer.process({.time = 1,
                           .motion = {.increment = {1, 0, 0}, .path_length = 1, .duration = 1},
                           .readings = {seenFrom({1, 0, 0}, kMap, {1}, kSensor, 1)}});
  EXPECT_EQ(recorded.time, 1);
  EXPECT_FALSE(recorded.compass);
  ASSERT_EQ(recorded.readings.size(), 2u);
  EXPECT_NEAR(recorded.readings[0].T_robot_sensor.x, kSensor.T_robot_sensor.x - 1, 1e-12);
}
}  // namespace mrpt_ext::test_windowed_localizer
