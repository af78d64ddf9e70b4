#include "mrpt_ext/evaluation/detection_gaps.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_detection_gaps
{
namespace
{
RunContext framesAt(const std::vector<double>& times)
{
  RunContext context;
  for (const double time : times) context.geometry.push_back({.time = time, .landmarks = 1});
  return context;
}

std::vector<ErrorSample> errorsAt(const std::vector<double>& stamps)
{
  std::vector<ErrorSample> errors;
  for (const double stamp : stamps) errors.push_back({.stamp = stamp});
  return errors;
}
}  // namespace

TEST(DetectionGaps, BlindBeginsTwoSecondsAfterTheLastDetection)
{
  const ErrorsByDetections split = splitByDetections(errorsAt({1, 2, 3, 3.5, 9, 10}), framesAt({1, 10}));
  ASSERT_EQ(split.with_detections.size(), 4u);
  EXPECT_EQ(split.with_detections[2].stamp, 3);
  EXPECT_EQ(split.with_detections[3].stamp, 10);
  ASSERT_EQ(split.blind.size(), 2u);
  EXPECT_EQ(split.blind[0].stamp, 3.5);
}

TEST(DetectionGaps, BeforeTheFirstDetectionTheRobotIsBlind)
{
  EXPECT_EQ(splitByDetections(errorsAt({1}), framesAt({2})).blind.size(), 1u);
}
}  // namespace mrpt_ext::test_detection_gaps
