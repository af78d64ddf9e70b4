#include "mrpt_ext/diagnosis/calibration_trajectory.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace mrpt_ext
{
namespace
{
/// The times of the estimates that are kept, one second each: 'o' ok, 'a' ambiguous with one dominant mode, 'm' several
/// modes, 'l' lost, 'h' ok without a heading.
std::vector<double> kept(const std::string& estimates, bool independent = false, bool heading_observable = true)
{
  LocalizationConfig config;
  config.frames.independent = independent;
  config.filter.heading_observable = heading_observable;
  CalibrationTrajectory trajectory(config);
  double time = 0;
  for (const char kind : estimates)
  {
    PoseEstimate estimate{.time = time++};
    if (kind == 'a' || kind == 'm') estimate.verdict = Verdict::ambiguous;
    if (kind == 'm') estimate.best_weight = 0.5;
    if (kind == 'l') estimate.verdict = Verdict::lost;
    if (kind == 'h') estimate.heading_known = false;
    trajectory.add(estimate);
  }
  std::vector<double> times;
  for (const PoseEstimate& estimate : trajectory.take()) times.push_back(estimate.time);
  return times;
}

using Times = std::vector<double>;

TEST(CalibrationTrajectory, AModeCountsFromItsFirstOkForAsLongAsItDominates)
{
  EXPECT_EQ(kept("aaooaaoam"), (Times{2, 3, 4, 5, 6, 7}));
}

TEST(CalibrationTrajectory, AmongSeveralModesAModeCountsIfItIsOkBeforeAndAfter)
{
  EXPECT_EQ(kept("oamaama"), (Times{0, 1}));
  EXPECT_EQ(kept("oamaamao"), (Times{0, 1, 3, 4, 6, 7}));
}

TEST(CalibrationTrajectory, LostEndsAMode) { EXPECT_EQ(kept("oalaaomala"), (Times{0, 1, 5})); }

TEST(CalibrationTrajectory, WithoutAnyOkTheLongestSpellCounts)
{
  EXPECT_EQ(kept("aamaaalaa"), (Times{3, 4, 5}));
  EXPECT_EQ(kept("aaaamo"), (Times{5}));
  EXPECT_TRUE(kept("mml").empty());
}

TEST(CalibrationTrajectory, AHeadingIsNeededWhereItIsObservable)
{
  EXPECT_EQ(kept("oho"), (Times{0, 2}));
  EXPECT_EQ(kept("oho", false, false), (Times{0, 1, 2}));
}

TEST(CalibrationTrajectory, CountsTheShareThatIsOk)
{
  CalibrationTrajectory trajectory({});
  EXPECT_EQ(trajectory.okShare(), 0);
  for (const Verdict verdict : {Verdict::ok, Verdict::ambiguous, Verdict::lost, Verdict::ambiguous})
    trajectory.add({.verdict = verdict});
  EXPECT_DOUBLE_EQ(trajectory.okShare(), 0.25);
}

/// Number of passes over a log of ranges, and the time of the estimate that is kept: 1 of the pass as configured, 2 of
/// the other one. The verdicts of four estimates each: 'o' ok, 'a' ambiguous.
std::pair<int, double> passesOver(const LocalizationInput& input, const std::string& first, const std::string& second)
{
  int passes = 0;
  const auto pass = [&](const LocalizationConfig& config)
  {
    EXPECT_EQ(config.biases.size(), input.config.biases.size() + static_cast<std::size_t>(passes));
    EXPECT_EQ(config.filter.biases.size(), static_cast<std::size_t>(passes));
    ++passes;
    CalibrationTrajectory trajectory(config);
    for (const char kind : passes == 1 ? first : second)
      trajectory.add({.time = double(passes), .verdict = kind == 'o' ? Verdict::ok : Verdict::ambiguous});
    return trajectory;
  };
  const std::vector<PoseEstimate> kept = likelierTrajectory(input, pass);
  return {passes, kept.front().time};
}

TEST(LikelierTrajectory, OfRangesAloneIsThatWhichIsOkMoreOften)
{
  using Passes = std::pair<int, double>;
  LocalizationInput input;
  input.log.available.identified_range = true;
  EXPECT_EQ(passesOver(input, "aaoa", "oooa"), (Passes{2, 2}));
  EXPECT_EQ(passesOver(input, "aaoa", "aaaa"), (Passes{2, 1}));
  EXPECT_EQ(passesOver(input, "ooaa", "oooo"), (Passes{1, 1})) << "the pose is known well enough";
  LocalizationInput with_points = input, stated = input;
  with_points.log.available.identified_point = true;
  EXPECT_EQ(passesOver(with_points, "aaoa", "oooo"), (Passes{1, 1})) << "bearings, too";
  stated.config.biases.push_back({.kind = BiasKind::range_offset, .std = 1});
  EXPECT_EQ(passesOver(stated, "aaoa", "oooo"), (Passes{1, 1})) << "the configuration says how uncertain ranges are";
}

TEST(CalibrationTrajectory, OfIndependentFramesEachMustBeOk)
{
  EXPECT_EQ(kept("aoaao", true), (Times{1, 4}));
  EXPECT_TRUE(kept("aaa", true).empty());
}
}  // namespace
}  // namespace mrpt_ext
