#include "mrpt_ext/localizers/kalman_localizer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_kalman_localizer
{
namespace
{
const PoseRegion kRegion{{-3, -3}, {9, 9}};

Frame frameAt(double time, const Pose2& robot, const Pose2& increment, const LandmarkTable& map,
              const std::vector<std::size_t>& landmarks, const ExactSensor& sensor, RandomStream& random)
{
  Reading reading = seenFrom(robot, map, landmarks, sensor, time);
  for (Detection& d : reading.detections)
    if (d.bearing) d.bearing = wrap(*d.bearing + d.std_bearing * random.gaussian());
  return {.time = time,
          .motion = {increment, increment.position().norm(), std::abs(increment.phi), time > 0 ? 0.5 : 0.0},
          .readings = {reading}};
}

KalmanLocalizer localizer(const std::string& name, std::size_t hypotheses, const LandmarkTable& map)
{
  return {name, {.max_hypotheses = hypotheses}, map, kRegion, 3, std::make_shared<const GlobalPoseSearch>(map)};
}
}  // namespace

TEST(KalmanLocalizer, LocalizesGloballyFromAnonymousBearings)
{
  const LandmarkTable map = fiveLandmarks();
  const ExactSensor anonymous{.identified = false, .std_bearing = degToRad(1)};
  for (const auto& [name, hypotheses] :
       {std::pair("extended_kalman_filter", std::size_t{1}), std::pair("kalman_filter_bank", std::size_t{50})})
    for (const std::uint64_t seed : {1U, 2U, 3U})
    {
      KalmanLocalizer filter = localizer(name, hypotheses, map);
      EXPECT_EQ(filter.name(), name);
      EXPECT_TRUE(filter.continuous());
      RandomStream random(seed, 9);
      Pose2 robot{2.5, 2, 0.7};
      Estimate estimate;
      for (int k = 0; k < 25; ++k)
      {
        const Pose2 step = k > 0 ? Pose2{0.15, 0, 0.08} : Pose2{};
        robot = compose(robot, step);
        estimate = filter.process(frameAt(0.5 * k, robot, step, map, {0, 1, 2, 3, 4}, anonymous, random));
      }
      ASSERT_TRUE(estimate.point) << name;
      EXPECT_EQ(estimate.point->verdict, Verdict::ok) << filter.lastStep().reason;
      EXPECT_LT((estimate.point->pose.mean.position() - robot.position()).norm(), 0.1) << name;
      EXPECT_LT(std::abs(wrap(estimate.point->pose.mean.phi - robot.phi)), degToRad(3)) << name;
    }
}

TEST(KalmanLocalizer, ARingOfEqualPosesHasNoEstimate)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}});
  const ExactSensor sensor{.range = true, .std_bearing = degToRad(1)};
  KalmanLocalizer filter = localizer("kalman_filter_bank", 50, map);
  RandomStream random(5);
  Estimate estimate;
  std::size_t most = 0;
  for (int k = 0; k < 45; ++k)
  {
    estimate = filter.process(frameAt(0.5 * k, {4, 2, kPi}, {}, map, {0}, sensor, random));
    most = std::max(most, estimate.candidates.size());
    EXPECT_FALSE(estimate.point);
  }
  EXPECT_GT(most, 5U) << "all are listed";
  EXPECT_TRUE(estimate.ambiguous);
}
}  // namespace mrpt_ext::test_kalman_localizer
