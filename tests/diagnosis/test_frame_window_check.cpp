#include "mrpt_ext/diagnosis/frame_window_check.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_frame_window_check
{
namespace
{
Reading readingAt(double time, const std::string& sensor, const std::vector<int>& ids)
{
  Reading reading;
  reading.time = time;
  reading.sensor = sensor;
  for (const int id : ids) reading.detections.push_back({.id = id});
  return reading;
}

std::vector<std::string> hintsOf(const std::vector<Reading>& readings)
{
  FrameWindowCheck check;
  Frame frame;
  frame.readings = readings;
  for (int k = 0; k < 10; ++k) check.add(frame);
  return check.hints();
}
}  // namespace

TEST(FrameWindowCheck, TwoPicturesOfOneCameraAreToldWithTheCommand)
{
  const auto hints = hintsOf({readingAt(1, "camera", {1, 2}), readingAt(1.033, "camera", {2, 3})});
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_NE(hints[0].find("10 of 10 frames"), std::string::npos) << hints[0];
  EXPECT_NE(hints[0].find("frame_window_s=0.016"), std::string::npos) << hints[0];
}

TEST(FrameWindowCheck, ARadioThatAsksOneAnchorAfterTheOtherIsFine)
{
  EXPECT_TRUE(hintsOf({readingAt(1, "radio", {1}), readingAt(1.01, "radio", {2})}).empty());
  EXPECT_TRUE(hintsOf({readingAt(1, "left", {1, 2}), readingAt(1.03, "right", {1, 2})}).empty());
  EXPECT_TRUE(hintsOf({readingAt(1, "scan", {kNoId}), readingAt(1.03, "scan", {kNoId})}).empty());
}

TEST(FrameWindowCheck, TwoScansWithoutIdsAreTold)
{
  EXPECT_EQ(hintsOf({readingAt(1, "scan", {kNoId, kNoId}), readingAt(1.03, "scan", {kNoId, kNoId})}).size(), 1u);
}
}  // namespace mrpt_ext::test_frame_window_check
