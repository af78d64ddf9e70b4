#include "mrpt_ext/simulation/barrier_planner.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_barrier_planner
{
namespace
{
const RobotPath kAlongX({0, 0, 0}, {{10, 1, 0}});

double distanceToPath(const Vector2d& post)
{
  double nearest = 1e9;
  for (double time = 0; time <= 10; time += 0.01)
    nearest = std::min(nearest, (kAlongX.poseAt(time).position() - post).norm());
  return nearest;
}
}  // namespace

TEST(PlanBarriers, RowsOfEvenlySpacedPostsBesideThePath)
{
  const BarrierPlan plan{.count = 6, .length = 2, .spacing = 0.5, .clearance = 0.7};
  RandomStream random(3, 0);
  const std::vector<Vector2d> posts = planBarriers(plan, {0, -4}, {10, 4}, kAlongX, random);
  ASSERT_EQ(posts.size(), 30U);
  for (std::size_t k = 0; k < posts.size(); ++k)
  {
    EXPECT_GT(distanceToPath(posts[k]), 0.7 - 0.05);
    const std::size_t row = k - k % 5;
    EXPECT_NEAR((posts[k] - posts[row]).norm(), 0.5 * static_cast<double>(k - row), 1e-5);
  }
  RandomStream again(3, 0);
  EXPECT_EQ(posts, planBarriers(plan, {0, -4}, {10, 4}, kAlongX, again));
}

TEST(PlanBarriers, NoRoomIsAnErrorOfTheConfiguration)
{
  RandomStream random(3, 0);
  EXPECT_THROW((void)planBarriers({.count = 1, .clearance = 20}, {0, -4}, {10, 4}, kAlongX, random), InputError);
}
}  // namespace mrpt_ext::test_barrier_planner
