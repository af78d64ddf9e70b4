#include "mrpt_ext/filter/hypothesis_injection.h"

#include <gtest/gtest.h>

namespace mrpt_ext
{
namespace
{
const Pose2 kHere{1, 1, 0}, kThere{5, 4, 2};

PoseHypothesis place(const Pose2& pose, double weight)
{
  PoseHypothesis h;
  h.pose = {pose, Vector3d(0.01, 0.04, 0.0025).asDiagonal()};
  h.weight = weight;
  return h;
}

ParticleSet oneHundredAt(const Pose2& pose)
{
  ParticleSet particles(Vector2d(0, 0));
  for (int i = 0; i < 100; ++i) particles.add(pose, std::log(0.01));
  return particles;
}
}  // namespace

TEST(WayPlaces, WhatAgreesWithThePlaceThatIsHeldChangesNothing)
{
  EXPECT_EQ(weightElsewhere({}, kHere), 0);
  EXPECT_EQ(weightElsewhere({place({1.2, 0.9, 0.1}, 1)}, kHere), 0);
  EXPECT_EQ(injectedShare(0, 0), 0);
}

TEST(WayPlaces, OthersCountByTheirOddsTenAtMost)
{
  EXPECT_NEAR(weightElsewhere({place(kThere, 0.5), place(kHere, 0.3)}, kHere), 0.5, 1e-12);
  EXPECT_NEAR(injectedShare(0.5, 0), 0.5, 1e-12);
  EXPECT_NEAR(injectedShare(0.999, 0), 10.0 / 11, 1e-12);
  EXPECT_NEAR(injectedShare(1, -3), 10.0 / 11, 1e-12);
}

TEST(WayPlaces, WhatIsProvenStands)
{
  EXPECT_LT(injectedShare(1, 9), kLeastPlaceShare);
  EXPECT_NEAR(injectedShare(1, std::log(10)), 0.5, 1e-12);
}

TEST(WayPlaces, PlacesGetTheirShareAndTheirShape)
{
  RandomStream random(1);
  ParticleSet particles = oneHundredAt(kHere);
  injectHypotheses(particles, {place(kThere, 0.6), place({9, 9, 1}, 0.2), place({2, 7, 1}, 1e-4)}, 0.8, 500, random);
  ASSERT_EQ(particles.size(), 1100U);
  double held = 0, there = 0, total = 0;
  Vector2d mean(0, 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double w = std::exp(double{particles.log_weight[i]});
    total += w;
    if (i < 100) held += w;
    if ((particles.pose(i).position() - kThere.position()).norm() > 2) continue;
    there += w;
    mean += w * particles.pose(i).position();
  }
  EXPECT_NEAR(held, 0.2, 1e-5);
  EXPECT_NEAR(there, 0.6, 1e-3);
  EXPECT_NEAR(total, 1, 1e-3);
  EXPECT_LT((mean / there - kThere.position()).norm(), 1e-4);  // the drawn moments are exact
}

TEST(WayPlaces, NoPlacesAreNoChange)
{
  RandomStream random(1);
  ParticleSet particles = oneHundredAt(kHere);
  injectHypotheses(particles, {}, 0.5, 500, random);
  EXPECT_EQ(particles.size(), 100U);
  EXPECT_FLOAT_EQ(particles.log_weight[0], std::log(0.01F));
}
}  // namespace mrpt_ext
