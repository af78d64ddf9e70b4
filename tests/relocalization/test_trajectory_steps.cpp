#include "mrpt_ext/relocalization/trajectory_steps.h"

#include <gtest/gtest.h>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_trajectory_steps
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const LandmarkIndex kIndex(kMap);
const MotionModel kModel{};

/// Straight ahead at 0.4 m/s, four frames per second, with these landmarks in every frame.
std::vector<Frame> drive(int frames, const std::vector<std::size_t>& landmarks, bool identified = false)
{
  std::vector<Frame> result;
  for (int k = 0; k < frames; ++k)
  {
    const double time = 0.25 * k, distance = k > 0 ? 0.1 : 0;
    const Reading reading = seenFrom({2 + 0.1 * k, 2, 0}, kMap, landmarks, {.identified = identified}, time);
    result.push_back(
        {.time = time, .motion = {{distance, 0, 0}, distance, 0, k > 0 ? 0.25 : 0}, .readings = {reading}});
  }
  return result;
}

std::size_t detectionsOf(const TrajectoryStep& step)
{
  std::size_t count = 0;
  for (const Scan& scan : step.scans) count += scan.detections.size();
  return count;
}
}  // namespace

TEST(TrajectorySteps, OdometryAddsUpOverTheFramesOfAStep)
{
  const auto frames = drive(8, {2});
  const auto steps = trajectorySteps(frames, kModel, kMap, kIndex, 1);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_NEAR(steps[0].increment.x, 0.3, 1e-12);
  EXPECT_NEAR(steps[1].increment.x, 0.4, 1e-12);
  GaussianPose expected;
  for (std::size_t k = 4; k < 8; ++k)
    expected = compound(expected, frames[k].motion.increment, incrementCovariance(kModel, frames[k].motion));
  EXPECT_TRUE(steps[1].noise.isApprox(expected.covariance, 1e-12));
}

TEST(TrajectorySteps, ALandmarkCountsOncePerStep)
{
  for (const TrajectoryStep& step : trajectorySteps(drive(8, {2}), kModel, kMap, kIndex, 1))
    EXPECT_LE(detectionsOf(step), 1U);
  EXPECT_EQ(detectionsOf(trajectorySteps(drive(4, {2}), kModel, kMap, kIndex, 1).front()), 1U);
  EXPECT_EQ(detectionsOf(trajectorySteps(drive(4, {1, 3}), kModel, kMap, kIndex, 1).front()), 2U);
}

TEST(TrajectorySteps, IdentifiedDetectionsAndNoFramesGiveNoScans)
{
  EXPECT_EQ(detectionsOf(trajectorySteps(drive(4, {1, 3}, true), kModel, kMap, kIndex, 1).front()), 0U);
  EXPECT_TRUE(trajectorySteps({}, kModel, kMap, kIndex, 1).empty());
}
}  // namespace mrpt_ext::test_trajectory_steps
