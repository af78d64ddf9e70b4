#include "mrpt_ext/filter/integrity/slip_test.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_slip_test
{
namespace
{
const MotionModel kMotion{};
constexpr double kMaxRange = 5;
const double kUniform = -std::log(kTwoPi * kMaxRange);

Reading reading(const Vector2d& landmark)
{
  Reading result;
  result.sensor = "laser";
  result.model.max_range = kMaxRange;
  result.model.clutter_probability = 0.05;
  Detection detection{.std_bearing = degToRad(1.0), .std_range = 0.05};
  detection.range = landmark.norm();
  detection.bearing = std::atan2(landmark.y(), landmark.x());
  result.detections = {detection};
  return result;
}

SlipTest after(double seconds)
{
  SlipTest test(kMotion, kMaxRange);
  test.suspect(seconds);
  return test;
}
}  // namespace

TEST(SlipTest, NothingIsSuspectedAtFirst)
{
  SlipTest test(kMotion, kMaxRange);
  EXPECT_TRUE(test.refuted());
  for (int k = 0; k < 100; ++k) test.count(reading({2, 1}), kUniform - 1);
  EXPECT_TRUE(test.refuted());
}

TEST(SlipTest, AShortSpellIsNoReasonToSuspectOne)
{
  EXPECT_TRUE(after(0.5).refuted());
  EXPECT_TRUE(after(0).refuted());
  EXPECT_FALSE(after(10).refuted());
}

TEST(SlipTest, APrecisePoseIsBelievedWithTheFirstLandmark)
{
  SlipTest test = after(10);
  test.count(reading({2, 1}), kUniform + 5);
  EXPECT_TRUE(test.refuted());
}

TEST(SlipTest, AnImprecisePoseNeedsSeveralLandmarks)
{
  SlipTest test = after(10);
  test.count(reading({2, 1}), kUniform + 0.8);
  EXPECT_FALSE(test.refuted()) << "it is as likely to fit by chance";
  // From now on it is expected without a map as well: as precisely as the pose does, and the more surely.
  for (int k = 0; k < 20; ++k) test.count(reading({2, 1}), kUniform + 3);
  EXPECT_FALSE(test.refuted()) << "the same one proves nothing";
}

TEST(SlipTest, AnotherLandmarkThatThePoseExpectsRefutesIt)
{
  SlipTest test = after(10);
  test.count(reading({2, 1}), kUniform + 0.8);
  EXPECT_FALSE(test.refuted());
  test.count(reading({1, -2}), kUniform + 5);
  EXPECT_TRUE(test.refuted());
}

TEST(SlipTest, WhatThePoseDoesNotExpectSpeaksForASlip)
{
  SlipTest test = after(10), without_clutter = after(10);
  test.count(reading({3, -2}), kUniform - 2);
  for (SlipTest* each : {&test, &without_clutter}) each->count(reading({2, 1}), kUniform + 2.5);
  EXPECT_FALSE(test.refuted());
  EXPECT_TRUE(without_clutter.refuted());
  test.clear();
  EXPECT_TRUE(test.refuted());
}

TEST(SlipTest, HoweverMuchClutterTwoLandmarksRefuteIt)
{
  SlipTest test = after(10);
  for (int k = 0; k < 50; ++k) test.count(reading({0.05 * k + 1, -2}), kUniform - 3);
  for (const Vector2d& landmark : {Vector2d(2, 1), Vector2d(-1, 3)}) test.count(reading(landmark), kUniform + 5);
  EXPECT_TRUE(test.refuted());
}

TEST(SlipTest, OnceRefutedItIsSuspectedAfterTheNextSpellOnly)
{
  SlipTest test = after(10);
  test.count(reading({2, 1}), kUniform + 5);
  for (int k = 0; k < 20; ++k) test.count(reading({1.0 + 0.1 * k, -2}), kUniform - 3);
  EXPECT_TRUE(test.refuted());
  test.suspect(10);
  EXPECT_FALSE(test.refuted());
}
}  // namespace mrpt_ext::test_slip_test
