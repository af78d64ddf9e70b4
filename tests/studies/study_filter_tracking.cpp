#include <Eigen/LU>
#include <cmath>
#include <iomanip>

#include "filter_scenario.h"
#include "mrpt_ext/evaluation/consistency.h"
#include "mrpt_ext/evaluation/error_statistics.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "posterior_bounds.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTransient = 2;  // [s]

/// The bound along the true trajectory, with the noise that the configuration states (which is the simulated one).
std::vector<Matrix3d> boundOf(const FilterScenario& scenario, const std::vector<FilterSample>& samples)
{
  std::vector<BoundStep> steps;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    BoundStep step;
    step.increment = k > 0 ? between(samples[k - 1].truth, samples[k].truth) : Pose2{};
    step.odometry_std = incrementStd(scenario.config.filter.motion, samples[k].frame->motion);
    for (const Reading& reading : samples[k].frame->readings)
      for (const Detection& d : reading.detections)
        addInformation(step.measurement_information,
                       bearingJacobian(samples[k].truth, scenario.map[*scenario.map.indexOf(d.id)].position.head<2>()),
                       d.std_bearing);
    steps.push_back(step);
  }
  return testing::posteriorBounds(samples.front().truth, scenario.config.filter.initial_pose.covariance, steps);
}

struct Sum
{
  double squared = 0, bound = 0;
  std::vector<double> nees, errors;  // NEES: mean of each run
  std::size_t reseeds = 0, not_ok = 0, steps = 0, inside = 0, ok = 0;
};

void addRun(const FilterScenario& scenario, std::uint64_t seed, Sum& sum)
{
  const std::vector<FilterSample> samples = runFilter(scenario, seed);
  const std::vector<Matrix3d> bounds = boundOf(scenario, samples);
  double nees = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    const FilterSample& sample = samples[k];
    if (sample.time < kTransient) continue;
    sum.squared += square(sample.distance());
    sum.bound += bounds[k](0, 0) + bounds[k](1, 1);
    sum.errors.push_back(sample.distance());
    nees += sample.nees();
    ++count;
    const bool ok = sample.step.verdict == Verdict::ok;
    sum.ok += ok ? 1 : 0;
    sum.inside += ok && sample.positionNees() < chiSquareQuantile(2, 0.95) ? 1 : 0;
    sum.not_ok += ok ? 0 : 1;
    sum.reseeds += sample.step.reseeded ? 1 : 0;
  }
  sum.steps += count;
  sum.nees.push_back(nees / static_cast<double>(count));
}

void run(std::ostream& out)
{
  const int runs = studyRuns(50);
  out << runs
      << " scenes of ini/landmark-simulator/tracking.ini, initial pose drawn from its stated distribution, from "
      << kTransient << " s on. NEES: mean over the runs, with the 95 % band of that mean (from the scatter of the "
      << "runs).\n\n| particles | RMSE [mm] | bound [mm] | RMSE / bound | median | 95 % | worst | NEES | its 95 % band "
      << "around 3 | not ok | reseeds | in 95 % region when ok |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const std::size_t particles : {100U, 300U, 1000U})
  {
    Sum sum;
    for (int k = 0; k < runs; ++k)
    {
      const std::uint64_t seed = studySeed(k);
      FilterScenario scenario = playScenario("tracking", seed);
      scenario.config.filter.particles = particles;
      RandomStream random(91, seed - 1);
      GaussianPose& start = scenario.config.filter.initial_pose;
      start.mean.x += std::sqrt(start.covariance(0, 0)) * random.gaussian();
      start.mean.y += std::sqrt(start.covariance(1, 1)) * random.gaussian();
      start.mean.phi = wrap(start.mean.phi + std::sqrt(start.covariance(2, 2)) * random.gaussian());
      addRun(scenario, seed - 1, sum);
    }
    const auto count = static_cast<double>(sum.steps);
    const ErrorStatistics errors = errorStatistics(sum.errors), nees = errorStatistics(sum.nees);
    const double band = 1.96 * *nees.std / std::sqrt(static_cast<double>(runs));
    const double rmse = std::sqrt(sum.squared / count), bound = std::sqrt(sum.bound / count);
    out << "| " << particles << std::fixed << std::setprecision(2) << " | " << 1e3 * rmse << " | " << 1e3 * bound
        << " | " << std::setprecision(3) << rmse / bound << std::setprecision(1) << " | " << 1e3 * *errors.median
        << " | " << 1e3 * *errors.p95 << " | " << 1e3 * *errors.max << std::setprecision(2) << " | " << *nees.mean
        << " | " << 3 - band << " - " << 3 + band << " | " << sum.not_ok << " of " << sum.steps << " | " << sum.reseeds
        << " | " << std::setprecision(3) << static_cast<double>(sum.inside) / static_cast<double>(sum.ok) << " |\n"
        << std::flush;
  }
}

const RegisterStudy kStudy("filter_tracking",
                           "How close does the particle filter come to the posterior Cramer-Rao bound with few "
                           "particles, and is its covariance consistent?",
                           run);
}  // namespace
}  // namespace mrpt_ext
