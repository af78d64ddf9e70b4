#include "mrpt_ext/solvers/two_circles.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_two_circles
{
TEST(TwoCircles, ThreeFourFive)
{
  const TwoCircles r = intersectCircles({{0, 0}, 5}, {{6, 0}, 5});
  EXPECT_EQ(r.relation, CircleRelation::two);
  EXPECT_LT((r.points[0] - Vector2d(3, 4)).norm(), 1e-12) << "first point left of the line of centres";
  EXPECT_LT((r.points[1] - Vector2d(3, -4)).norm(), 1e-12);
}

TEST(TwoCircles, PointsLieOnBothCircles)
{
  RandomStream random(41);
  int met = 0;
  for (int trial = 0; trial < 5000; ++trial)
  {
    const Circle a{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(0, 6)};
    const Circle b{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(0, 6)};
    const TwoCircles r = intersectCircles(a, b);
    met += r.count;
    for (int k = 0; k < r.count; ++k)
    {
      const Vector2d& p = r.points[static_cast<std::size_t>(k)];
      EXPECT_NEAR((p - a.centre).norm(), a.radius, 1e-6);
      EXPECT_NEAR((p - b.centre).norm(), b.radius, 1e-6);
    }
    if (r.count > 0) continue;
    // The midpoint of the gap is as far from one circle as from the other.
    const double to_a = std::abs((r.closest - a.centre).norm() - a.radius);
    const double to_b = std::abs((r.closest - b.centre).norm() - b.radius);
    EXPECT_NEAR(to_a, 0.5 * r.gap, 1e-9);
    EXPECT_NEAR(to_b, 0.5 * r.gap, 1e-9);
  }
  EXPECT_GT(met, 2000);
}

TEST(TwoCircles, OrderOfTheCirclesDoesNotMatter)
{
  RandomStream random(42);
  for (int trial = 0; trial < 500; ++trial)
  {
    const Circle a{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(0, 6)};
    const Circle b{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(0, 6)};
    const TwoCircles ab = intersectCircles(a, b), ba = intersectCircles(b, a);
    ASSERT_EQ(ab.relation, ba.relation);
    EXPECT_LT((ab.points[0] - ba.points[1]).norm(), 1e-6);
    EXPECT_LT((ab.closest - ba.closest).norm(), 1e-9);
  }
}
}  // namespace mrpt_ext::test_two_circles
