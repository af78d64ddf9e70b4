#include "mrpt_ext/filter/integrity/point_null_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_point_null_model
{
namespace
{
const MotionModel kExact{
    .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
constexpr double kMaxRange = 5;
const double kUniform = -std::log(kTwoPi * kMaxRange);

Reading laser()
{
  Reading reading;
  reading.sensor = "laser";
  reading.T_robot_sensor = {0.1, 0.2, 0.3};
  reading.model.max_range = kMaxRange;
  reading.model.clutter_probability = 0.05;
  return reading;
}

Detection at(double range, double bearing)
{
  Detection detection{.std_bearing = degToRad(1.0), .std_range = 0.05};
  detection.range = range;
  detection.bearing = bearing;
  return detection;
}

Detection of(const Vector2d& post, const Pose2& robot)
{
  const Pose2 sensor = laser().T_robot_sensor;
  return at(predictRange(robot, post, sensor), predictBearing(robot, post, sensor));
}

OdometryMotion aheadBy(double distance) { return {{distance, 0, 0}, distance, 0, 1}; }
}  // namespace

TEST(PointNullModel, TheFirstDetectionHasAUniformDensity)
{
  PointNullModel model(kExact, 20);
  EXPECT_NEAR(model.observe(laser(), at(2, 1)).log_density, kUniform, 1e-12);
}

TEST(PointNullModel, AFeatureIsExpectedAgainFromWhereverItIsSeen)
{
  const Vector2d post(2, 1);
  PointNullModel model(kExact, 20);
  double last = 0;
  for (int k = 0; k < 8; ++k)
  {
    last = model.observe(laser(), of(post, {0.3 * k, 0, 0})).log_density;
    model.move(aheadBy(0.3));
  }
  EXPECT_EQ(model.size(), 1U);
  EXPECT_GT(last, kUniform + 5);
  EXPECT_LT(model.observe(laser(), at(4, -2)).log_density, kUniform) << "new features have become rare";
  EXPECT_EQ(model.size(), 2U);
}

TEST(PointNullModel, OdometryForgetsWhereAFeatureIs)
{
  const MotionModel loose{.std_xy_per_m = 0.2, .std_phi_per_deg = 0, .std_phi_per_m = degToRad(10.0)};
  const auto density = [](const MotionModel& motion)
  {
    PointNullModel model(motion, 20);
    for (int k = 0; k < 5; ++k) (void)model.observe(laser(), of({2, 1}, {0, 0, 0}));
    for (int k = 0; k < 10; ++k) model.move(aheadBy(0.1));
    return model.observe(laser(), of({2, 1}, {1, 0, 0})).log_density;
  };
  EXPECT_LT(density(loose), density(kExact) - 2);
}

TEST(PointNullModel, ItsDensityIntegratesToOne)
{
  PointNullModel model(kExact, 20);
  for (int k = 0; k < 4; ++k)
    for (const Vector2d& post : {Vector2d(2, 1), Vector2d(1.5, -1)}) (void)model.observe(laser(), of(post, {0, 0, 0}));
  constexpr int kRanges = 500, kBearings = 720;
  const double cell = kMaxRange / kRanges * kTwoPi / kBearings;
  double sum = 0;
  for (int i = 0; i < kRanges; ++i)
    for (int k = 0; k < kBearings; ++k)
    {
      PointNullModel copy = model;
      const double range = (i + 0.5) * kMaxRange / kRanges, bearing = (k + 0.5) * kTwoPi / kBearings - kPi;
      sum += cell * std::exp(copy.observe(laser(), at(range, bearing)).log_density);
    }
  EXPECT_NEAR(sum, 1, 0.01);
}

TEST(PointNullModel, FeaturesOfAnotherCategoryOrSensorAreNotExpected)
{
  PointNullModel model(kExact, 20);
  for (int k = 0; k < 10; ++k) (void)model.observe(laser(), at(2, 1));
  Detection pole = at(2, 1);
  pole.category = "pole";
  EXPECT_NEAR(model.observe(laser(), pole).log_density, kUniform, 1e-9);
  Reading other = laser();
  other.sensor = "other";
  EXPECT_NEAR(model.observe(other, at(2, 1)).log_density, kUniform, 1e-9);
}

TEST(PointNullModel, AFeatureThatIsSeenAgainTellsWhereTheOthersAre)
{
  const MotionModel turning{.std_xy_per_m = 0, .std_phi_per_deg = 0.3, .std_phi_per_m = 0};
  const Vector2d post(2, 1), beside(1, 2);
  const auto density = [&](bool sees_post)
  {
    PointNullModel model(turning, 20);
    for (int k = 0; k < 5; ++k)
      for (const Vector2d& one : {post, beside}) (void)model.observe(laser(), of(one, {0, 0, 0}));
    model.move({{0, 0, 1}, 0, 1, 1});
    const Pose2 slipped{0, 0, 1.1};  // by more than odometry measured
    if (sees_post) (void)model.observe(laser(), of(post, slipped));
    return model.observe(laser(), of(beside, slipped)).log_density;
  };
  EXPECT_GT(density(true), density(false) + 1);
}

TEST(PointNullModel, CorrelatedDetectionsMoveAFeatureAndCountForNothing)
{
  const MotionModel loose{.std_xy_per_m = 0.1, .std_phi_per_deg = 0, .std_phi_per_m = degToRad(10.0)};
  const auto after = [&](bool tracks)
  {
    PointNullModel model(loose, 20);
    for (int k = 0; k < 5; ++k) (void)model.observe(laser(), of({2, 1}, {0, 0, 0}));
    for (int k = 1; k <= 10; ++k)
    {
      model.move(aheadBy(0.1));
      if (tracks) model.track(laser(), of({2, 1}, {0.1 * k, 0, 0.03 * k}));
    }
    return model;
  };
  PointNullModel tracked = after(true), lost = after(false);
  EXPECT_EQ(tracked.size(), 1U);
  EXPECT_GT(tracked.observe(laser(), of({2, 1}, {1, 0, 0.3})).log_density,
            lost.observe(laser(), of({2, 1}, {1, 0, 0.3})).log_density + 1);
  PointNullModel model(loose, 20);
  model.track(laser(), at(2, 1));
  EXPECT_EQ(model.size(), 0U) << "never a new one";
}

TEST(PointNullModel, AFeatureThatIsMissedIsExpectedLess)
{
  PointNullModel model(kExact, 20);
  for (int k = 0; k < 5; ++k)
    for (const Vector2d& post : {Vector2d(2, 1), Vector2d(1.5, -1)}) (void)model.observe(laser(), of(post, {0, 0, 0}));
  PointNullModel missing = model;
  for (int k = 0; k < 20; ++k) (void)missing.observe(laser(), of({2, 1}, {0, 0, 0}));
  const auto density = [](PointNullModel copy) { return copy.observe(laser(), of({1.5, -1}, {0, 0, 0})).log_density; };
  EXPECT_LT(density(missing), density(model) - 1);
}
}  // namespace mrpt_ext::test_point_null_model
