#include "mrpt_ext/localizers/particle_filter_localizer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_particle_filter_localizer
{
namespace
{
const ExactSensor kAnonymous{.identified = false, .std_bearing = degToRad(1)};

ParticleFilterOptions optionsFor(const Vector2d& low, const Vector2d& high)
{
  ParticleFilterOptions options;
  options.particles = 1000;
  options.initial_particles = 8000;
  options.region = {low, high};
  return options;
}

Frame noisyFrame(double time, const Pose2& robot, const Pose2& increment, const LandmarkTable& map,
                 const std::vector<std::size_t>& landmarks, RandomStream& random)
{
  Reading reading = seenFrom(robot, map, landmarks, kAnonymous, time);
  for (Detection& d : reading.detections) d.bearing = wrap(*d.bearing + d.std_bearing * random.gaussian());
  return {.time = time,
          .motion = {increment, increment.position().norm(), std::abs(increment.phi), time > 0 ? 0.5 : 0.0},
          .readings = {reading}};
}
}  // namespace

TEST(ParticleFilterLocalizer, LocalizesGloballyFromAnonymousBearings)
{
  const LandmarkTable map = fiveLandmarks();
  for (const std::uint64_t seed : {1u, 2u, 3u})
  {
    ParticleFilterLocalizer filter(optionsFor({-3, -3}, {9, 9}), map, 3, seed);
    RandomStream random(seed, 9);
    Pose2 robot{2.5, 2, 0.7};
    Estimate estimate;
    for (int k = 0; k < 25; ++k)
    {
      const Pose2 step = k > 0 ? Pose2{0.15, 0, 0.08} : Pose2{};
      robot = compose(robot, step);
      estimate = filter.process(noisyFrame(0.5 * k, robot, step, map, {0, 1, 2, 3, 4}, random));
    }
    ASSERT_TRUE(estimate.point);
    EXPECT_LT(distance(estimate.point->pose.mean, robot), 0.2) << seed;
    EXPECT_LT(turned(estimate.point->pose.mean, robot), degToRad(4)) << seed;
    EXPECT_EQ(estimate.point->verdict, Verdict::ok) << filter.lastStep().reason;
    EXPECT_TRUE(confidentHeading(filter));
    EXPECT_EQ(filter.landmarkHistories().size(), map.size());
    for (const LandmarkHistory& history : filter.landmarkHistories()) EXPECT_GT(history.associated, 0.8 * history.seen);
  }
}

TEST(ParticleFilterLocalizer, ReportsAllModesWhileAmbiguous)
{
  // A square of landmarks has a symmetry of a quarter turn.
  const LandmarkTable square(
      {{.position = {0, 0, 0}}, {.position = {4, 0, 0}}, {.position = {4, 4, 0}}, {.position = {0, 4, 0}}});
  ParticleFilterLocalizer filter(optionsFor({0, 0}, {4, 4}), square, 3, 5);
  RandomStream random(6);
  Pose2 robot{1, 1.5, 0.3};
  for (int k = 0; k < 12; ++k)
  {
    const Pose2 step = k > 0 ? Pose2{0.05, 0, 0.05} : Pose2{};
    robot = compose(robot, step);
    const Estimate estimate = filter.process(noisyFrame(0.5 * k, robot, step, square, {0, 1, 2, 3}, random));
    EXPECT_NE(filter.lastStep().verdict, Verdict::ok) << k;
    if (k < 3) continue;
    ASSERT_TRUE(estimate.point);
    EXPECT_EQ(estimate.point->verdict, Verdict::ambiguous) << filter.lastStep().reason;
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const Vector2d there = Vector2d(2, 2) + rotation(quarter * kPi / 2) * (robot.position() - Vector2d(2, 2));
      const Pose2 twin{there.x(), there.y(), wrap(robot.phi + quarter * kPi / 2)};
      const auto found = std::find_if(estimate.candidates.begin(), estimate.candidates.end(),
                                      [&](const auto& h)
                                      { return distance(h.pose.mean, twin) < 0.3 && turned(h.pose.mean, twin) < 0.2; });
      ASSERT_NE(found, estimate.candidates.end()) << "frame " << k << " quarter " << quarter;
      EXPECT_NEAR(found->weight, 0.25, 0.1);
    }
    EXPECT_FALSE(confidentHeading(filter));
  }
}

// Ranges do not determine the heading at standstill: the true one must still have particles when the robot starts to
// move.
TEST(ParticleFilterLocalizer, RangesAtStandstillKeepAllHeadings)
{
  const LandmarkTable map = fiveLandmarks();
  ParticleFilterOptions options = optionsFor({-3, -3}, {9, 9});
  options.biases = {{.kind = BiasKind::range_offset, .std = 0.3}, {.kind = BiasKind::range_scale, .std = 0.1}};
  ParticleFilterLocalizer filter(options, map, 3, 4);
  RandomStream random(8);
  Pose2 robot{2.5, 2, -2.2};
  const auto hear = [&](int k, const Pose2& step)
  {
    robot = compose(robot, step);
    const ExactSensor radio{.bearing = false, .range = true, .std_range = 0.1};
    Reading reading = seenFrom(robot, map, {static_cast<std::size_t>(k % 4)}, radio, 0.5 * k);
    *reading.detections.front().range *= 1.06;
    *reading.detections.front().range += 0.1 * random.gaussian();
    return filter.process({.time = 0.5 * k,
                           .motion = {step, step.position().norm(), std::abs(step.phi), k > 0 ? 0.5 : 0.0},
                           .readings = {reading}});
  };
  for (int k = 0; k < 60; ++k) (void)hear(k, {});
  std::vector<double> share(12);
  const ParticleSet& particles = filter.particles();
  for (std::size_t i = 0; i < particles.size(); ++i)
    share[static_cast<std::size_t>((particles.pose(i).phi + kPi) / kTwoPi * 12) % 12] +=
        1.0 / static_cast<double>(particles.size());
  for (const double held : share) EXPECT_GT(held, 0.04);  // of 1 / 12
  EXPECT_NE(filter.lastStep().verdict, Verdict::ok);

  Estimate estimate;
  for (int k = 60; k < 100; ++k) estimate = hear(k, {0.1, 0, 0.02});
  ASSERT_TRUE(estimate.point);
  EXPECT_LT(distance(estimate.point->pose.mean, robot), 0.4);
  EXPECT_LT(turned(estimate.point->pose.mean, robot), degToRad(12));
}

TEST(ParticleFilterLocalizer, TheSameSeedGivesTheSameEstimates)
{
  const LandmarkTable map = fiveLandmarks();
  std::vector<double> x;
  for (int run = 0; run < 2; ++run)
  {
    ParticleFilterLocalizer filter(optionsFor({-3, -3}, {9, 9}), map, 3, 11, 2);
    RandomStream random(1);
    for (int k = 0; k < 5; ++k)
    {
      const Estimate e = filter.process(noisyFrame(0.5 * k, {2.5, 2, 0.7}, {}, map, {0, 1, 2, 3}, random));
      x.push_back(e.point ? e.point->pose.mean.x : -1);
    }
  }
  EXPECT_TRUE(std::equal(x.begin(), x.begin() + 5, x.begin() + 5));
}
}  // namespace mrpt_ext::test_particle_filter_localizer
