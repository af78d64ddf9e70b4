#include "mrpt_ext/geometry/angle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpt_ext::test_angle
{
TEST(Wrap, KeepsAnglesAlreadyInRange)
{
  EXPECT_EQ(wrap(0.0), 0.0);
  EXPECT_EQ(wrap(kPi), kPi);
  EXPECT_EQ(wrap(1.0), 1.0);
}

TEST(Wrap, MapsMinusPiToPi) { EXPECT_DOUBLE_EQ(wrap(-kPi), kPi); }

TEST(Wrap, TurnsOnceRound)
{
  EXPECT_NEAR(wrap(kTwoPi + 0.5), 0.5, 1e-12);
  EXPECT_NEAR(wrap(-3 * kPi - 0.5), kPi - 0.5, 1e-12);
}

RC_GTEST_PROP(Wrap, IsInRangeAndKeepsTheDirection, (double raw))
{
  const double angle = std::fmod(raw, 1e4);
  RC_PRE(std::isfinite(angle));
  const double wrapped = wrap(angle);
  RC_ASSERT(wrapped > -kPi);
  RC_ASSERT(wrapped <= kPi);
  RC_ASSERT(std::abs(std::sin(wrapped) - std::sin(angle)) < 1e-9);
  RC_ASSERT(std::abs(std::cos(wrapped) - std::cos(angle)) < 1e-9);
}
}  // namespace mrpt_ext::test_angle
