#include "mrpt_ext/solvers/sight_agreement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::test_sight_agreement
{
namespace
{
/// From a corner of a triangle of 0.35 m to a point, with an error of the direction and of the distance.
RangedSight sight(const Vector2d& from, const Vector2d& to, double off_deg = 0, double scale = 1)
{
  const Vector2d way = to - from;
  return {{from, std::atan2(way.y(), way.x()) + degToRad(off_deg), degToRad(0.05)}, scale * way.norm()};
}
const Vector2d kPlaces[] = {{-0.17, 0.1}, {0.17, 0.1}, {0, -0.2}};
constexpr double kTurned = degToRad(2);
}  // namespace

TEST(SightAgreement, OneObjectIsSeenInOnePlace)
{
  for (const Vector2d& object : {Vector2d(2, 3), Vector2d(-1, 0.8), Vector2d(0, -5)})
  {
    std::vector<RangedSight> sights;
    for (std::size_t i = 0; i < 3; ++i)
      sights.push_back(sight(kPlaces[i], object, i == 1 ? 1.0 : -0.5, i ? 0.8 : 1.25));
    EXPECT_EQ(confirmedSights(sights, kTurned), std::vector<bool>(3, true));
  }
}

TEST(SightAgreement, WhatOneCameraTakesForItIsLeftOut)
{
  const Vector2d pole(2, 3), person(0.5, 3.5);
  EXPECT_EQ(confirmedSights({sight(kPlaces[0], pole), sight(kPlaces[1], person), sight(kPlaces[2], pole)}, kTurned),
            (std::vector{true, false, true}));
}

TEST(SightAgreement, TwoThatContradictEachOtherAreBothLeftOut)
{
  const Vector2d pole(2, 3), person(0.5, 3.5);
  EXPECT_EQ(confirmedSights({sight(kPlaces[0], pole), sight(kPlaces[1], person)}, kTurned),
            std::vector<bool>(2, false));
}

TEST(SightAgreement, OneAloneIsBelieved)
{
  EXPECT_TRUE(confirmedSights({}, kTurned).empty());
  EXPECT_EQ(confirmedSights({sight(kPlaces[0], {1, 1})}, kTurned), std::vector<bool>(1, true));
}
}  // namespace mrpt_ext::test_sight_agreement
