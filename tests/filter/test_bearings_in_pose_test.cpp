#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "mrpt_ext/filter/integrity/sequential_pose_test.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "simulated_run.h"

namespace mrpt_ext::test_bearings_in_pose_test
{
namespace
{
const PoseRegion kRegion{{0, 0}, {10, 10}};
constexpr int kStepsBefore = 300;

/// The highest log odds of a robot in a map that is moved by `off` within `steps` after it is put to the test anew,
/// late in a drive past five of fifteen landmarks. Their bearings are anonymous; `std_turn`: of odometry's heading in
/// one step [rad].
double highestOddsAnew(const Pose2& off, double std_turn, int steps, std::uint64_t seed)
{
  const SimulatedRobot robot{.odometry_std = {0.01, 0.01, std_turn},
                             .std_bearing = degToRad(2),
                             .identified = false,
                             .detections = 2,
                             .clutter = 0.1};
  RandomStream random(seed);
  const LandmarkTable map = randomMap(15, 10, random);
  const LandmarkTable shown({map[0], map[1], map[2], map[3], map[4]});
  SequentialPoseTest test(motionModelOf(robot), map);
  Pose2 truth{5, 2, 0};
  double highest = 0;
  for (int k = 0; k < kStepsBefore + steps; ++k)
  {
    if (k == kStepsBefore) test.reset();
    truth = compose(truth, roundTripStep(k));
    test.update(simulatedFrame(robot, shown, truth, roundTripStep(k), random), map,
                particlesAt(compose(off, truth), random));
    if (k >= kStepsBefore) highest = std::max(highest, test.logOdds());
  }
  return highest;
}
}  // namespace

// Most features of the null model are those that odometry has lost: in view, but not where a landmark is seen.
TEST(BearingsInPoseTest, TheRightPoseIsVerifiedThoughTheNullModelHasManyFeaturesInView)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    EXPECT_GE(highestOddsAnew({}, degToRad(3), 60, seed), SequentialPoseTest::kAcceptLogOdds) << "seed " << seed;
}

// The particles know the true turns; the null model knows them by the first feature that it recognizes.
TEST(BearingsInPoseTest, AWrongPoseIsNotVerified)
{
  int verified = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    RandomStream random(seed, 1);
    const Pose2 off = kRegion.sample(random);
    verified += highestOddsAnew(off, degToRad(3), 150, seed) >= SequentialPoseTest::kAcceptLogOdds ? 1 : 0;
  }
  EXPECT_EQ(verified, 0);
}
}  // namespace mrpt_ext::test_bearings_in_pose_test
