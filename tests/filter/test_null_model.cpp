#include "mrpt_ext/filter/integrity/null_model.h"

#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext::test_null_model
{
namespace
{
constexpr double kStd = degToRad(1.0);
const MotionModel kExact{
    .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};

Reading camera()
{
  Reading reading;
  reading.sensor = "camera";
  reading.model.clutter_probability = 0.05;
  return reading;
}

Detection bearingOf(double bearing)
{
  Detection detection{.std_bearing = kStd};
  detection.bearing = bearing;
  return detection;
}

OdometryMotion aheadBy(double distance) { return {{distance, 0, 0}, distance, 0, 1}; }

const double kUniform = -std::log(kTwoPi);
}  // namespace

TEST(NullModel, TheFirstBearingHasAUniformDensity)
{
  NullModel model(kExact, 20);
  EXPECT_NEAR(model.observe(camera(), bearingOf(1)).log_density, kUniform, 1e-12);
}

TEST(NullModel, AFeatureIsExpectedAgain)
{
  NullModel model(kExact, 20);
  double last = kUniform;
  for (int k = 0; k < 10; ++k) last = model.observe(camera(), bearingOf(1)).log_density;
  EXPECT_EQ(model.size(), 1U);
  EXPECT_GT(last, kUniform + 3);
  EXPECT_LT(model.observe(camera(), bearingOf(-1)).log_density, kUniform);  // new features have become rare
  EXPECT_EQ(model.size(), 2U);
}

TEST(NullModel, ParallaxIsLearnedAndThenExpected)
{
  const Vector2d post(3, 2);
  NullModel model(kExact, 20);
  std::vector<double> densities;
  for (int k = 0; k < 12; ++k)
  {
    densities.push_back(model.observe(camera(), bearingOf(predictBearing({0.3 * k, 0, 0}, post))).log_density);
    model.move(aheadBy(0.3));
  }
  EXPECT_EQ(model.size(), 1U);
  EXPECT_GT(densities[11], densities[1]);
  EXPECT_GT(densities[11], kUniform + 3);
}

TEST(NullModel, ItsDensityIntegratesToOne)
{
  NullModel model(kExact, 20);
  for (int k = 0; k < 4; ++k)
    for (const Vector2d& post : {Vector2d(3, 2), Vector2d(4, -1)})
    {
      (void)model.observe(camera(), bearingOf(predictBearing({0.3 * k, 0, 0}, post)));
      model.move(aheadBy(0.15));
    }
  double sum = 0;
  constexpr int kSteps = 3600;
  for (int k = 0; k < kSteps; ++k)
  {
    NullModel copy = model;
    const auto outcome = copy.observe(camera(), bearingOf(-kPi + (k + 0.5) * kTwoPi / kSteps));
    sum += std::exp(outcome.log_density) * kTwoPi / kSteps;
  }
  EXPECT_NEAR(sum, 1, 0.01);
}

// A feature that is followed just outside the view, and some in view that are not seen any more.
TEST(NullModel, InAFieldOfViewItsDensityIntegratesToOneAtMost)
{
  MotionModel drifting = kExact;
  drifting.std_phi_per_s = degToRad(2);
  Reading narrow = camera();
  narrow.model.field_of_view = degToRad(60.0);
  NullModel model(drifting, 20);
  for (const double lost : {-20.0, -10.0, 0.0}) (void)model.observe(narrow, bearingOf(degToRad(lost)));
  for (int k = 0; k < 100; ++k) (void)model.observe(narrow, bearingOf(degToRad(29.0)));
  model.move({{0, 0, degToRad(-2.0)}, 0, degToRad(-2.0), 1});
  double sum = 0;
  constexpr int kSteps = 600;
  for (int k = 0; k < kSteps; ++k)
  {
    NullModel copy = model;
    const double bearing = narrow.model.field_of_view * ((k + 0.5) / kSteps - 0.5);
    sum += std::exp(copy.observe(narrow, bearingOf(bearing)).log_density) * narrow.model.field_of_view / kSteps;
  }
  EXPECT_LT(sum, 1.05);
  EXPECT_GT(sum, 0.3) << "the rest is out of view";
}

TEST(NullModel, RandomBearingsDoNotFitBetterThanAUniformDensity)
{
  RandomStream random(3);
  NullModel model(kExact, 20);
  double gained = 0;
  for (int k = 0; k < 200; ++k)
  {
    gained += model.observe(camera(), bearingOf(random.uniform(-kPi, kPi))).log_density - kUniform;
    model.move(aheadBy(0.3));
  }
  EXPECT_LT(gained, 5);
}

// A robot that turns sees many features once; then it stands before one of them.
TEST(NullModel, AfterManyNewFeaturesOneThatIsSeenAgainIsRecognized)
{
  NullModel model(kExact, 20);
  for (int k = 0; k < 20; ++k) (void)model.observe(camera(), bearingOf(-3 + 0.3 * k));
  const double share_new = model.observe(camera(), bearingOf(0.15)).share_new;
  FeatureMixture::Outcome last;
  for (int k = 0; k < 60; ++k) last = model.observe(camera(), bearingOf(0.15));
  EXPECT_GT(share_new, 0.9);
  EXPECT_LT(last.share_new, 0.6);
  EXPECT_TRUE(last.isKnown());
}

TEST(NullModel, CorrelatedBearingsMoveTheirFeatureAndTellNothingAboutNewOnes)
{
  MotionModel drifting = kExact;
  drifting.std_phi_per_s = degToRad(2);
  NullModel tracking(drifting, 20), blind(drifting, 20);
  for (NullModel* model : {&tracking, &blind})
    for (int k = 0; k < 2; ++k) (void)model->observe(camera(), bearingOf(1));
  for (int k = 0; k < 25; ++k)
  {
    const OdometryMotion turn_that_is_none{.increment = {0, 0, degToRad(1)}, .turned = degToRad(1), .duration = 1};
    tracking.move(turn_that_is_none);
    blind.move(turn_that_is_none);
    tracking.track(camera(), bearingOf(1));
  }
  const FeatureMixture::Outcome tracked = tracking.observe(camera(), bearingOf(1));
  const FeatureMixture::Outcome lost = blind.observe(camera(), bearingOf(1));
  EXPECT_EQ(tracked.share_new, lost.share_new);
  EXPECT_GT(tracked.log_density, lost.log_density + 1) << "odometry alone has lost the direction";
  EXPECT_EQ(tracking.size(), 1U);
}

// As a pose with two landmarks knows it.
TEST(NullModel, AFeatureTellsWhereOthersAreThoughOdometryHasLostTheHeading)
{
  MotionModel drifting = kExact;
  drifting.std_phi_per_s = degToRad(5);
  NullModel model(drifting, 20);
  RandomStream random(5);
  double heading = 0, first = 0, second = 0;
  for (int k = 0; k < 100; ++k)
  {
    const double a = model.observe(camera(), bearingOf(wrap(1 - heading))).log_density;
    const double b = model.observe(camera(), bearingOf(wrap(1.5 - heading))).log_density;
    if (k >= 50) first += a / 50, second += b / 50;
    heading += drifting.std_phi_per_s * random.gaussian();
    model.move({.duration = 1});
  }
  EXPECT_GT(second, first + 1);
}

// Most features in view are those that odometry has lost.
TEST(NullModel, FeaturesThatAreNotSeenAnyMoreLeaveTheirShareToOthers)
{
  NullModel many(kExact, 20), one(kExact, 20);
  for (int k = 0; k < 20; ++k) (void)many.observe(camera(), bearingOf(-3 + 0.3 * k));
  for (NullModel* model : {&many, &one})
    for (int k = 0; k < 200; ++k) (void)model->observe(camera(), bearingOf(0.15));
  const auto density = [](NullModel& model, double bearing)
  { return model.observe(camera(), bearingOf(bearing)).log_density; };
  EXPECT_GT(density(many, 0.15), density(one, 0.15) - 0.5) << "as if the others were not in view";
  EXPECT_GT(density(many, -3), density(one, -3) + 1) << "but one of them may come back";
}

TEST(NullModel, ACorrelatedBearingThatFitsNothingIsNoFeature)
{
  NullModel model(kExact, 20);
  model.track(camera(), bearingOf(1));
  EXPECT_EQ(model.size(), 0U);
  (void)model.observe(camera(), bearingOf(1));
  model.track(camera(), bearingOf(2));
  EXPECT_EQ(model.size(), 1U);
  EXPECT_NEAR(model.observe(camera(), bearingOf(2)).share_new, 2.0 / 3, 1e-12) << "one so far, which was new";
}

TEST(NullModel, FeaturesOfAnotherCategoryOrSensorAreNotExpected)
{
  NullModel model(kExact, 20);
  for (int k = 0; k < 10; ++k) (void)model.observe(camera(), bearingOf(1));
  Detection post = bearingOf(1);
  post.category = "post";
  EXPECT_NEAR(model.observe(camera(), post).log_density, kUniform, 1e-9);
  Reading other = camera();
  other.sensor = "other";
  EXPECT_NEAR(model.observe(other, bearingOf(1)).log_density, kUniform, 1e-9);
  model.clear();
  EXPECT_EQ(model.size(), 0U);
}
}  // namespace mrpt_ext::test_null_model
