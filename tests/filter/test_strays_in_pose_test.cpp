#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/filter/integrity/sequential_pose_test.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "simulated_run.h"

namespace mrpt_ext::test_strays_in_pose_test
{
namespace
{
const PoseRegion kRegion{{0, 0}, {10, 10}};
constexpr int kSteps = 150;

/// Log odds of a pose `off` the true one after each frame of a drive past ten anonymous landmarks and three things that
/// are not in the map, such as people who stand.
std::vector<double> oddsAmongStrays(bool measures_range, const Pose2& off, std::uint64_t seed)
{
  RandomStream random(seed);
  const LandmarkTable shown = randomMap(13, 10, random);
  std::vector<Landmark> landmarks;
  for (std::size_t k = 0; k < 10; ++k) landmarks.push_back(shown[k]);
  const LandmarkTable map(landmarks);
  const SimulatedRobot robot{.measures_range = measures_range, .identified = false, .clutter = 0.2};
  SequentialPoseTest test(motionModelOf({}), map);
  Pose2 truth{5, 2, 0};
  std::vector<double> odds;
  for (int k = 0; k < kSteps; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    test.update(simulatedFrame(robot, shown, truth, roundTripStep(k), random), map,
                particlesAt(compose(truth, off), random));
    odds.push_back(test.logOdds());
  }
  return odds;
}
}  // namespace

TEST(StraysInPoseTest, TheRightPoseIsVerifiedAndNotRefuted)
{
  for (const bool measures_range : {true, false})
  {
    int refuted = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const std::vector<double> odds = oddsAmongStrays(measures_range, {}, seed);
      refuted += *std::min_element(odds.begin(), odds.end()) <= SequentialPoseTest::kRejectLogOdds ? 1 : 0;
      EXPECT_GE(*std::max_element(odds.begin(), odds.end()), SequentialPoseTest::kAcceptLogOdds)
          << measures_range << ", seed " << seed;
    }
    EXPECT_EQ(refuted, 0) << "range " << measures_range;
  }
}

TEST(StraysInPoseTest, AWrongPoseIsNotVerified)
{
  for (const bool measures_range : {true, false})
  {
    int verified = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed)
    {
      RandomStream random(seed, 1);
      const std::vector<double> odds =
          oddsAmongStrays(measures_range, compose({-1, -1, 0}, kRegion.sample(random)), seed);
      verified += *std::max_element(odds.begin(), odds.end()) >= SequentialPoseTest::kAcceptLogOdds ? 1 : 0;
    }
    EXPECT_EQ(verified, 0) << "range " << measures_range;
  }
}
}  // namespace mrpt_ext::test_strays_in_pose_test
