#include "mrpt_ext/calibration/independent_readings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_independent_readings
{
namespace
{
constexpr double kRate = 10;  // [Hz]
const std::pair<std::size_t, bool> kBearings{0, false}, kRanges{0, true};

/// Bearings and ranges to two landmarks for ten minutes, and what they are wrong by in standard deviations: bearings
/// white, ranges by first-order Gauss-Markov processes.
struct Recorded
{
  Recorded(double time_constant, RandomStream& random)
  {
    const double kept = time_constant > 0 ? std::exp(-1 / (kRate * time_constant)) : 0;
    std::array<double, 2> lasting{random.gaussian(), random.gaussian()};
    for (std::size_t k = 0; k < 6000; ++k)
    {
      problem.poses.push_back({.time = static_cast<double>(k) / kRate});
      for (std::size_t landmark = 0; landmark < 2; ++landmark)
        for (const bool is_range : {false, true})
        {
          problem.readings.push_back({.pose = k, .is_range = is_range, .landmark_number = landmark});
          double& error = lasting[landmark];
          if (is_range) error = kept * error + std::sqrt(1 - kept * kept) * random.gaussian();
          misfits.push_back(is_range ? error : random.gaussian());
        }
    }
  }
  CalibrationProblem problem;
  std::vector<double> misfits;
};
}  // namespace

TEST(CorrelationTimes, OfWhiteErrorsTheyAreZero)
{
  RandomStream random(1);
  const Recorded recorded(0, random);
  const CorrelationTimes times = correlationTimes(recorded.problem, recorded.misfits);
  EXPECT_EQ(times.at(kBearings), 0);
  EXPECT_EQ(times.at(kRanges), 0);
  const std::vector<bool> independent = independentReadings(recorded.problem, times);
  EXPECT_EQ(std::count(independent.begin(), independent.end(), true), 24000);
}

TEST(CorrelationTimes, OfAGaussMarkovProcessItIsTheTimeConstant)
{
  for (const double time_constant : {0.5, 2.0, 8.0})
  {
    RandomStream random(2);
    const Recorded recorded(time_constant, random);
    const CorrelationTimes times = correlationTimes(recorded.problem, recorded.misfits);
    EXPECT_EQ(times.at(kBearings), 0);
    EXPECT_GE(times.at(kRanges), 0.8 * time_constant);
    EXPECT_LE(times.at(kRanges), 2.2 * time_constant) << "spacings are doubled";
  }
}

TEST(CorrelationTimes, OutliersCountAsFarAsTheyExceedAnOutliersMisfit)
{
  RandomStream random(3);
  Recorded recorded(0, random);
  for (std::size_t i = 0; i < recorded.misfits.size(); i += 300) recorded.misfits[i] = 1e6;
  EXPECT_EQ(correlationTimes(recorded.problem, recorded.misfits).at(kBearings), 0);
}

TEST(IndependentReadings, OfEachLandmarkTheFirstAfterTheCorrelationTime)
{
  CalibrationProblem problem;
  for (std::size_t k = 0; k < 5; ++k)
  {
    problem.poses.push_back({.time = static_cast<double>(k)});
    problem.readings.push_back({.pose = k, .is_range = true, .landmark_number = 0});
    if (k > 0) problem.readings.push_back({.pose = k, .is_range = true, .landmark_number = 1});
    problem.readings.push_back({.pose = k});
  }
  //                                0     b  0      1      b  0     1     b  0      1      b  0     1     b
  const std::vector<bool> expected{true, 1, false, true, 1, true, false, 1, false, true, 1, true, false, 1};
  EXPECT_EQ(independentReadings(problem, {{kRanges, 2.0}}), expected);
  EXPECT_EQ(independentReadings(problem, {}), std::vector<bool>(14, true));
}

TEST(IndependentReadings, StampsThatAreRoundedLeaveOutNone)
{
  CalibrationProblem problem;
  for (std::size_t k = 0; k < 100; ++k)
  {
    problem.poses.push_back({.time = static_cast<double>(k) / kRate + (k % 3 == 0 ? 0.004 : 0)});
    problem.readings.push_back({.pose = k, .is_range = true});
  }
  for (const auto& [spacing, kept] : {std::pair{0.1, 100}, {0.2, 50}, {0.4, 25}})
  {
    const std::vector<bool> independent = independentReadings(problem, {{kRanges, spacing}});
    EXPECT_EQ(std::count(independent.begin(), independent.end(), true), kept) << spacing;
  }
}

TEST(CorrelationTimes, FewReadingsTellNone)
{
  CalibrationProblem problem;
  for (std::size_t k = 0; k < 10; ++k)
  {
    problem.poses.push_back({.time = static_cast<double>(k)});
    problem.readings.push_back({.pose = k});
  }
  EXPECT_EQ(correlationTimes(problem, std::vector<double>(10, 1.0)).at(kBearings), 0);
  EXPECT_TRUE(correlationTimes({}, {}).empty());
}
}  // namespace mrpt_ext::test_independent_readings
