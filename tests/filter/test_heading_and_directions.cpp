#include "mrpt_ext/filter/integrity/heading_and_directions.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::test_heading_and_directions
{
namespace
{
constexpr double kVariance = square(degToRad(1)), kTurn = square(degToRad(5));

HeadingAndDirections twoSeenBeforeATurn()
{
  HeadingAndDirections errors;
  errors.add(kVariance);
  errors.add(kVariance);
  errors.turn(kTurn);
  return errors;
}
}  // namespace

TEST(HeadingAndDirections, ATurnMakesAllBearingsUncertain)
{
  const HeadingAndDirections errors = twoSeenBeforeATurn();
  ASSERT_EQ(errors.size(), 2);
  for (const int k : {0, 1}) EXPECT_NEAR(errors.bearingVariance(k), kTurn + kVariance, 1e-12);
}

TEST(HeadingAndDirections, OneThatIsSeenTellsWhereTheOtherIs)
{
  HeadingAndDirections errors = twoSeenBeforeATurn();
  const double innovation = degToRad(4), share = kTurn / (kTurn + kVariance);
  const auto correction = errors.update(0, innovation, kVariance, 0);
  EXPECT_NEAR(correction.directions(0) - correction.heading, innovation * share, 1e-12);
  EXPECT_NEAR(correction.heading, -innovation * share * share, 1e-12) << "a larger bearing: turned by less";
  EXPECT_NEAR(correction.directions(1), 0, 1e-12);
  EXPECT_NEAR(errors.bearingVariance(0), kVariance, 1e-12) << "as one measurement tells it";
  EXPECT_NEAR(errors.bearingVariance(1), kVariance + kTurn * (1 - share * share), 1e-12);
}

TEST(HeadingAndDirections, OneThatIsFollowedHoldsTheHeading)
{
  HeadingAndDirections errors = twoSeenBeforeATurn();
  for (int k = 0; k < 1000; ++k)
  {
    errors.turn(0.1 * kVariance);
    (void)errors.update(0, 0, kVariance, 0);
  }
  EXPECT_LT(errors.bearingVariance(1), 4 * kVariance) << "by odometry alone 100 times";
}

TEST(HeadingAndDirections, AFeatureOfUnknownRangeTellsLessOfTheHeading)
{
  HeadingAndDirections errors = twoSeenBeforeATurn(), unknown_range = errors;
  (void)errors.update(0, 0, kVariance, 0);
  (void)unknown_range.update(0, 0, kVariance, kTurn);
  EXPECT_GT(unknown_range.bearingVariance(1), errors.bearingVariance(1) + 0.5 * kTurn);
}

TEST(HeadingAndDirections, ManyBearingsTellNoMoreThanTheErrorThatTheyShare)
{
  HeadingAndDirections errors = twoSeenBeforeATurn();
  for (int k = 0; k < 50; ++k) (void)errors.update(0, 0, kVariance, 0);
  EXPECT_NEAR(errors.bearingVariance(0), kVariance, 0.05 * kVariance);
}

TEST(HeadingAndDirections, OthersAreAsTheyWereWhenOneIsRemoved)
{
  HeadingAndDirections errors;
  for (const int k : {1, 4, 9}) errors.add(k * kVariance);
  errors.turn(kTurn);
  HeadingAndDirections all = errors;
  errors.remove(1);
  ASSERT_EQ(errors.size(), 2);
  EXPECT_NEAR(errors.bearingVariance(0), kTurn + kVariance, 1e-12);
  EXPECT_NEAR(errors.bearingVariance(1), kTurn + 9 * kVariance, 1e-12);
  (void)errors.update(1, 0, kVariance, 0);
  (void)all.update(2, 0, kVariance, 0);
  EXPECT_NEAR(errors.bearingVariance(0), all.bearingVariance(0), 1e-12);
}
}  // namespace mrpt_ext::test_heading_and_directions
