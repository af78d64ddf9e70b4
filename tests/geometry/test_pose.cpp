#include "mrpt_ext/geometry/pose.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpt_ext::test_pose
{
namespace
{
Pose2 poseFrom(int x, int y, int phi) { return {x % 1000 / 10.0, y % 1000 / 10.0, wrap(phi % 1000 / 100.0)}; }

void expectNear(const Pose2& a, const Pose2& b, double tolerance)
{
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(std::abs(wrap(a.phi - b.phi)), 0.0, tolerance);
}
}  // namespace

TEST(Pose, ComposeTurnsTheStepIntoTheWorld)
{
  expectNear(compose({1, 2, kPi / 2}, {3, 0, 0.5}), {1, 5, kPi / 2 + 0.5}, 1e-12);
}

TEST(Pose, TransformMovesAPoint)
{
  const Vector2d p = transform({1, 2, kPi}, {1, 1});
  EXPECT_NEAR(p.x(), 0, 1e-12);
  EXPECT_NEAR(p.y(), 1, 1e-12);
}

RC_GTEST_PROP(Pose, InverseUndoes, (int x, int y, int phi))
{
  const Pose2 pose = poseFrom(x, y, phi);
  const Pose2 none = compose(pose, inverse(pose));
  RC_ASSERT(std::abs(none.x) < 1e-9 && std::abs(none.y) < 1e-9 && std::abs(none.phi) < 1e-9);
}

RC_GTEST_PROP(Pose, BetweenIsWhatComposeNeeds, (int x, int y, int phi, int u, int v, int w))
{
  const Pose2 a = poseFrom(x, y, phi), b = poseFrom(u, v, w);
  const Pose2 again = compose(a, between(a, b));
  RC_ASSERT(std::abs(again.x - b.x) < 1e-9 && std::abs(again.y - b.y) < 1e-9);
  RC_ASSERT(std::abs(wrap(again.phi - b.phi)) < 1e-9);
}

RC_GTEST_PROP(Pose, ComposeJacobiansMatchDifferences, (int x, int y, int phi, int u, int v, int w))
{
  const Pose2 a = poseFrom(x, y, phi), b = poseFrom(u, v, w);
  const double h = 1e-6;
  for (int k = 0; k < 3; ++k)
  {
    Vector3d step = Vector3d::Zero();
    step[k] = h;
    const Pose2 a2{a.x + step[0], a.y + step[1], a.phi + step[2]}, b2{b.x + step[0], b.y + step[1], b.phi + step[2]};
    const Pose2 c = compose(a, b), ca = compose(a2, b), cb = compose(a, b2);
    const Vector3d da((ca.x - c.x) / h, (ca.y - c.y) / h, wrap(ca.phi - c.phi) / h);
    const Vector3d db((cb.x - c.x) / h, (cb.y - c.y) / h, wrap(cb.phi - c.phi) / h);
    RC_ASSERT((da - composeJacobianFirst(a, b).col(k)).norm() < 1e-3);
    RC_ASSERT((db - composeJacobianSecond(a).col(k)).norm() < 1e-3);
  }
}
}  // namespace mrpt_ext::test_pose
