#include "mrpt_ext/localizers/sliced_localizer.h"

#include <gtest/gtest.h>

#include <vector>

#include "../hypotheses/exact_scene.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"

namespace mrpt_ext::test_sliced_localizer
{
namespace
{
/// A drive among anonymous landmarks: the start is a search, and dear.
std::vector<Frame> anonymousDrive(const LandmarkTable& map)
{
  RandomStream random(3, 9);
  Pose2 robot{2.5, 2, 0.7};
  std::vector<Frame> frames;
  for (int k = 0; k < 25; ++k)
  {
    const Pose2 step = k > 0 ? Pose2{0.15, 0, 0.08} : Pose2{};
    robot = compose(robot, step);
    Reading reading = seenFrom(robot, map, {0, 1, 2, 3, 4}, {.identified = false, .std_bearing = degToRad(1)}, 0.5 * k);
    for (Detection& d : reading.detections) d.bearing = wrap(*d.bearing + d.std_bearing * random.gaussian());
    frames.push_back({.time = 0.5 * k,
                      .motion = {step, step.position().norm(), std::abs(step.phi), k > 0 ? 0.5 : 0.0},
                      .readings = {reading}});
  }
  return frames;
}

struct SlicedRun
{
  std::vector<Estimate> estimates;
  std::vector<std::string> reasons;
  std::vector<double> times;
  std::size_t late = 0;         // frames that were not finished in their own step
  std::uint64_t most_work = 0;  // operations of a step
};

SlicedRun runOf(double step_budget_ms)
{
  const LandmarkTable map = fiveLandmarks();
  ParticleFilterOptions options;
  options.particles = 1000;
  options.initial_particles = 8000;
  options.region = {{-3, -3}, {9, 9}};
  ParticleFilterLocalizer filter(options, map, 3, 3);
  SlicedLocalizer sliced([&](const Frame& frame) { return filter.process(frame); }, step_budget_ms);
  SlicedRun run;
  const auto step = [&]
  {
    const std::uint64_t before = WorkCounter::done();
    while (const auto finished = sliced.next())
    {
      run.estimates.push_back(finished->estimate);
      run.times.push_back(finished->frame.time);
      run.reasons.push_back(filter.lastStep().reason);
    }
    run.most_work = std::max(run.most_work, WorkCounter::done() - before);
    run.late += sliced.hasWaiting() ? 1 : 0;
  };
  for (const Frame& frame : anonymousDrive(map))
  {
    sliced.add(frame);
    step();
  }
  while (sliced.hasWaiting())
  {
    sliced.goOn();
    step();
  }
  return run;
}

void expectSame(const SlicedRun& a, const SlicedRun& b)
{
  EXPECT_EQ(a.times, b.times);
  EXPECT_EQ(a.reasons, b.reasons);
  ASSERT_EQ(a.estimates.size(), b.estimates.size());
  for (std::size_t k = 0; k < a.estimates.size(); ++k)
  {
    ASSERT_EQ(a.estimates[k].point.has_value(), b.estimates[k].point.has_value()) << k;
    if (!a.estimates[k].point) continue;
    EXPECT_EQ(a.estimates[k].point->pose.mean.vector(), b.estimates[k].point->pose.mean.vector()) << k;
    EXPECT_EQ(a.estimates[k].point->pose.covariance, b.estimates[k].point->pose.covariance) << k;
    EXPECT_EQ(a.estimates[k].point->verdict, b.estimates[k].point->verdict) << k;
  }
}

/// A localizer of a given cost per frame.
SlicedLocalizer::Process costing(std::vector<std::uint64_t> operations, std::size_t& processed)
{
  return [operations = std::move(operations), &processed](const Frame&)
  {
    for (std::uint64_t k = 0; k < operations.at(std::min(processed, operations.size() - 1)); k += 10)
      WorkCounter::add(10);
    ++processed;
    return Estimate{};
  };
}

std::size_t count(SlicedLocalizer& sliced)
{
  std::size_t count = 0;
  while (sliced.next()) ++count;
  return count;
}
}  // namespace

TEST(SlicedLocalizer, EstimatesAreTheSameWhateverAStepMayDo)
{
  const SlicedRun unlimited = runOf(0);
  EXPECT_EQ(unlimited.late, 0U);
  ASSERT_TRUE(unlimited.estimates.back().point);
  EXPECT_EQ(unlimited.estimates.back().point->verdict, Verdict::ok);
  EXPECT_GT(unlimited.most_work, 10'000'000U) << "else there is nothing to divide";
  for (const double budget : {0.5, 3.0, 1000.0, 1e30})
  {
    const SlicedRun sliced = runOf(budget);
    expectSame(sliced, unlimited);
    EXPECT_EQ(sliced.late == 0, budget >= 1000) << budget;
  }
}

TEST(SlicedLocalizer, NoStepDoesMuchMoreThanItMay)
{
  EXPECT_LT(runOf(10).most_work, 15'000'000U) << "what is not divided is short";
}

TEST(SlicedLocalizer, LaterFramesWaitAndAreCaughtUpWith)
{
  std::size_t processed = 0;
  SlicedLocalizer sliced(costing({1'200'000, 60'000}, processed), 1);
  const auto step = [&](double time)
  {
    sliced.add({.time = time});
    return count(sliced);
  };
  EXPECT_EQ(step(0), 0U);
  EXPECT_EQ(step(1), 0U);
  EXPECT_EQ(step(2), 3U);
  EXPECT_FALSE(sliced.hasWaiting());
  EXPECT_EQ(step(3), 1U);
}

TEST(SlicedLocalizer, AStepWithoutAFrameGoesOn)
{
  std::size_t processed = 0;
  SlicedLocalizer sliced(costing({1'200'000}, processed), 1);
  sliced.add({});
  EXPECT_EQ(count(sliced), 0U);
  sliced.goOn();
  EXPECT_EQ(count(sliced), 0U);
  sliced.goOn();
  EXPECT_EQ(count(sliced), 1U);
}

TEST(SlicedLocalizer, LatenessIsTold)
{
  std::size_t processed = 0;
  SlicedLocalizer sliced(costing({1'200'000, 60'000}, processed), 1);
  std::vector<std::size_t> late;
  for (int k = 0; k < 4; ++k)
  {
    sliced.add({});
    while (const auto finished = sliced.next()) late.push_back(finished->steps_late);
  }
  EXPECT_EQ(late, (std::vector<std::size_t>{2, 1, 0, 0}));
  EXPECT_EQ(reasonWithLateness("one mode", late[0]), "one mode; 2 steps late");
  EXPECT_EQ(reasonWithLateness("one mode", late[1]), "one mode; 1 step late");
  EXPECT_EQ(reasonWithLateness("one mode", late[2]), "one mode");
}

TEST(SlicedLocalizer, WhatAStepDoesNotNeedIsNotSaved)
{
  std::size_t processed = 0;
  SlicedLocalizer sliced(costing({10, 900'000}, processed), 1);
  sliced.add({});
  EXPECT_EQ(count(sliced), 1U);
  sliced.add({});
  EXPECT_EQ(count(sliced), 0U);
}

TEST(SlicedLocalizer, OneThatIsAlwaysTooSlowTakesLongerSteps)
{
  std::size_t processed = 0;
  SlicedLocalizer sliced(costing({900'000}, processed), 1);
  for (std::size_t k = 1; k <= 4 * SlicedLocalizer::kMostWaiting; ++k)
  {
    sliced.add({});
    (void)count(sliced);
    EXPECT_LE(k - processed, SlicedLocalizer::kMostWaiting + 1) << k;
  }
}
}  // namespace mrpt_ext::test_sliced_localizer
