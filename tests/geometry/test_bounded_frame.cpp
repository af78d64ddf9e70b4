#include "mrpt_ext/geometry/bounded_frame.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_bounded_frame
{
namespace
{
Reading readingOf(std::size_t detections)
{
  Reading reading{.sensor = "sensor"};
  reading.model.detection_probability = 0.7;
  for (std::size_t d = 0; d < detections; ++d)
    reading.detections.push_back({.bearing = 0.001 * static_cast<double>(d), .std_bearing = 0.01});
  return reading;
}
}  // namespace

TEST(BoundedFrame, AUsualFrameStaysAsItIs)
{
  EXPECT_FALSE(boundedFrame({}));
  EXPECT_FALSE(boundedFrame({.readings = {readingOf(60), readingOf(0), readingOf(kMostDetections - 60)}}));
}

TEST(BoundedFrame, OfTooManyDetectionsEachReadingKeepsItsShare)
{
  const auto bounded = boundedFrame({.time = 3, .readings = {readingOf(3000), readingOf(0), readingOf(1000)}});
  ASSERT_TRUE(bounded);
  EXPECT_EQ(bounded->time, 3);
  EXPECT_EQ(detectionCount(*bounded), kMostDetections);
  ASSERT_EQ(bounded->readings.size(), 3u);
  EXPECT_EQ(bounded->readings[0].detections.size(), 3 * kMostDetections / 4);
  EXPECT_EQ(bounded->readings[2].detections.size(), kMostDetections / 4);
  EXPECT_FALSE(bounded->readings[0].model.detection_probability) << "what was left out is not missed";
  EXPECT_TRUE(bounded->readings[1].model.detection_probability);
  EXPECT_GT(*bounded->readings[0].detections.back().bearing, 2.9) << "in all directions";
}

TEST(BoundedFrame, CountsThousandsOfReadingsTogether)
{
  const auto bounded = boundedFrame({.readings = std::vector<Reading>(5000, readingOf(1))});
  ASSERT_TRUE(bounded);
  EXPECT_EQ(bounded->readings.size(), kMostDetections);
}

TEST(BoundedFrame, WorkThatGrowsWithTheDetectionsLeavesItsShareOfThem)
{
  const Frame frame{.readings = {readingOf(60), readingOf(40)}};
  EXPECT_FALSE(affordableFrame(frame, 1e6, 1e6));
  EXPECT_EQ(detectionCount(affordableFrame(frame, 1e6, 3e5).value()), 30u);
  EXPECT_EQ(detectionCount(affordableFrame(frame, 1e6, 1).value()), 1u) << "never none";
}
}  // namespace mrpt_ext::test_bounded_frame
