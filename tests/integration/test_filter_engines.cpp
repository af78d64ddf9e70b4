#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "scratch_folder.h"
#include "test_length.h"
#include "whole_runs.h"

// Our engine and MRPT's own filter over the same map give the same posterior within sampling error. Both run the same
// log several times with different random seeds; the spread over the seeds is the measure for the difference of the
// means. Neither learns reliability nor recovers, so that both compute the same model.
namespace mrpt_ext::test_filter_engines
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;

constexpr int kTrials = 6;
const std::string kParticles =
    std::string("LocalizationExperiment.particles_count=") + (testing::isShort() ? "500" : "5000");

/// Mean pose and deviations of one step in one trial: x, y, phi, std x, std y, std phi.
using Posterior = Eigen::Array<double, 6, 1>;

Posterior posteriorOf(const testing::StepRow& step)
{
  Posterior p;
  p << step.x, step.y, step.phi, std::sqrt(step.cxx), std::sqrt(step.cyy), std::sqrt(step.cpp);
  return p;
}

/// Mean and variance over the trials, per step.
struct Spread
{
  std::vector<Posterior> mean, variance;
};

Spread spreadOf(const fs::path& run)
{
  std::vector<std::vector<Posterior>> trials;
  for (int trial = 0; trial < kTrials; ++trial)
  {
    trials.emplace_back();
    for (const auto& step : testing::stepsOf(run / ("trial_00" + std::to_string(trial))))
    {
      Posterior p = posteriorOf(step);
      // Headings near 180 degrees: all on one side, that of the first trial.
      if (trial > 0)
      {
        const double reference = trials[0][trials.back().size()](2);
        p(2) = reference + wrap(p(2) - reference);
      }
      trials.back().push_back(p);
    }
  }
  Spread spread;
  for (std::size_t k = 0; k < trials[0].size(); ++k)
  {
    Posterior mean = Posterior::Zero(), variance = Posterior::Zero();
    for (const auto& trial : trials) mean += trial.at(k) / kTrials;
    for (const auto& trial : trials) variance += (trial.at(k) - mean).square() / (kTrials - 1);
    spread.mean.push_back(mean);
    spread.variance.push_back(variance);
  }
  return spread;
}

/// How far two engines are apart, averaged over the log.
struct Difference
{
  /// Squared difference of the means over its variance; 1 is expected of two equal posteriors, a little more for few
  /// trials: the square of a t-distributed figure with 2 (kTrials - 1) degrees of freedom has mean 1.25.
  Posterior normalized = Posterior::Zero();
  /// Of the means of x, y, phi: RMS in units of the posterior's deviation.
  Eigen::Array3d of_means = Eigen::Array3d::Zero();
  /// Of the deviations: mean ratio.
  Eigen::Array3d ratio_of_stds = Eigen::Array3d::Zero();
};

Difference differenceOf(const Spread& a, const Spread& b)
{
  Difference d;
  const std::size_t first = 20;  // before, the resampling has not set in
  const auto count = static_cast<double>(a.mean.size() - first);
  for (std::size_t k = first; k < a.mean.size(); ++k)
  {
    Posterior apart = a.mean[k] - b.mean[k];
    apart(2) = wrap(apart(2));
    d.normalized += apart.square() / ((a.variance[k] + b.variance[k]) / kTrials) / count;
    d.of_means += (apart.head<3>() / a.mean[k].tail<3>()).square() / count;
    d.ratio_of_stds += b.mean[k].tail<3>() / a.mean[k].tail<3>() / count;
  }
  d.of_means = d.of_means.sqrt();
  return d;
}

class FilterEngines : public ::testing::Test
{
 protected:
  Spread run(const std::string& engine, int seed, const Arguments& more = {})
  {
    const Arguments arguments{"--set",    "LocalizationExperiment.filter_engine=" + engine,
                              "--set",    kParticles,
                              "--set",    "LocalizationExperiment.methods=particle_filter",
                              "--set",    "ParticleFilter.learn_reliability=false",
                              "--set",    "ParticleFilter.reseed_inlier_ratio=0",
                              "--repeat", std::to_string(kTrials),
                              "--jobs",   "2",
                              "--seed",   std::to_string(seed)};
    const fs::path place = folder_.path() / std::to_string(++count_);
    fs::create_directory(place);
    return spreadOf(
        testing::localized(place, "tracking", testing::joined(testing::joined(log_.arguments(), arguments), more)));
  }

  testing::ScratchFolder folder_;
  testing::LogFiles log_ = testing::simulated(folder_.path(), "tracking", {"--set", "Simulation.duration_s=15"});
  int count_ = 0;
};
}  // namespace

TEST_F(FilterEngines, GiveTheSamePosterior)
{
  const Spread batch = run("batch", 1), reference = run("mrpt", 2);
  ASSERT_EQ(batch.mean.size(), 151U);
  ASSERT_EQ(reference.mean.size(), batch.mean.size());
  const Difference d = differenceOf(batch, reference);
  if (testing::isShort()) return;  // too few particles for the bounds
  for (int i = 0; i < 6; ++i) EXPECT_LT(d.normalized(i), 4) << "figure " << i;
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_LT(d.of_means(i), 0.15) << "axis " << i;
    EXPECT_NEAR(d.ratio_of_stds(i), 1, 0.06) << "axis " << i;
  }
}

TEST_F(FilterEngines, AnotherNoiseIsAnotherPosterior)
{
  // The comparison above would see a standard deviation that is wrong by a quarter.
  const Difference d = differenceOf(run("batch", 1), run("batch", 2, {"--set", "Sensor_camera.std_bearing_deg=1.25"}));
  if (testing::isShort()) return;
  EXPECT_GT(d.ratio_of_stds.maxCoeff(), 1.06);
  EXPECT_GT(d.normalized.maxCoeff(), 4);
}
}  // namespace mrpt_ext::test_filter_engines
