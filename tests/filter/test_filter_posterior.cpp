#include <gtest/gtest.h>

#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "simulated_run.h"

namespace mrpt_ext::test_filter_posterior
{
namespace
{
// Two landmarks on the x axis leave two mirror-image poses; the imprecise range to the third distinguishes them
// slightly.
const LandmarkTable kMap({{.id = 1, .position = {1, 0, 0}},
                          {.id = 2, .position = {3, 0, 0}},
                          {.id = 3, .position = {2, 2.5, 0}}});
const PoseRegion kRegion{{-1, -3}, {5, 3}};

Frame stillFrame(double first_range, double second_range, double third_range)
{
  Reading reading;
  reading.model = {.max_range = 10.0, .clutter_probability = 0.05};
  reading.detections = {{.id = 1, .range = first_range, .std_range = 0.3},
                        {.id = 2, .range = second_range, .std_range = 0.3},
                        {.id = 3, .range = third_range, .std_range = 1.5},
                        {.id = 1, .bearing = 0.4, .std_bearing = 0.4}};
  Frame frame;
  frame.readings = {reading};
  return frame;
}

/// A posterior as weighted poses; exact on a grid, or the particles.
struct WeightedPoses
{
  std::vector<Pose2> poses;
  std::vector<double> weights;

  void normalize()
  {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& w : weights) w /= sum;
  }
};

struct Moments
{
  double weight = 0;
  Vector3d mean = Vector3d::Zero(), std = Vector3d::Zero();  // x, y, bearing-like heading component
};

/// Of the half plane above or below the x axis; the heading enters as the direction to landmark 1 minus heading.
Moments moments(const WeightedPoses& posterior, bool upper)
{
  Moments result;
  Vector3d sum2 = Vector3d::Zero();
  for (std::size_t i = 0; i < posterior.poses.size(); ++i)
  {
    const Pose2& pose = posterior.poses[i];
    if ((pose.y > 0) != upper) continue;
    const Vector3d v(pose.x, pose.y, predictBearing(pose, {1, 0}));
    result.weight += posterior.weights[i];
    result.mean += posterior.weights[i] * v;
    sum2 += posterior.weights[i] * v.cwiseAbs2();
  }
  result.mean /= result.weight;
  result.std = (sum2 / result.weight - result.mean.cwiseAbs2()).cwiseSqrt();
  return result;
}

/// Exact Bayes on a grid for a robot that stands still, but may jump anywhere before every frame but the first.
WeightedPoses exactPosterior(const std::vector<Frame>& frames, double jump)
{
  const int n = 80, turns = 60;
  WeightedPoses grid;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < turns; ++k)
        grid.poses.push_back({-1 + 6 * (i + 0.5) / n, -3 + 6 * (j + 0.5) / n, -kPi + kTwoPi * (k + 0.5) / turns});
  const double uniform = 1.0 / static_cast<double>(grid.poses.size());
  grid.weights.assign(grid.poses.size(), uniform);
  for (std::size_t f = 0; f < frames.size(); ++f)
  {
    for (std::size_t i = 0; i < grid.poses.size(); ++i)
    {
      if (f > 0) grid.weights[i] = (1 - jump) * grid.weights[i] + jump * uniform;
      grid.weights[i] *= std::exp(logLikelihood(frames[f].readings[0], kMap, grid.poses[i]));
    }
    grid.normalize();
  }
  return grid;
}

ParticleFilterOptions stillOptions()
{
  ParticleFilterOptions options;
  options.region = kRegion;
  options.particles = 40000;
  options.initial_particles = 100000;
  options.resample_below = 0.01;
  options.motion = {.std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
  options.learn_reliability = false;
  options.recovery.reseed_inlier_ratio = -1;
  return options;
}

PoseHypothesis proposal(const Pose2& mean, double weight)
{
  return {.pose = {mean, Vector3d(0.1, 0.1, 0.1).asDiagonal()}, .weight = weight};
}

/// Inexact seeds with wrong weights, and one far from any mode.
HypothesisSet badProposals()
{
  return {proposal({2.1, -1.0, 1.5}, 0.8), proposal({1.7, 1.5, -2.2}, 0.1), proposal({4, 2, 0}, 0.1)};
}

WeightedPoses particlesOf(const ParticleFilter& filter)
{
  WeightedPoses result;
  for (std::size_t i = 0; i < filter.particles().size(); ++i) result.poses.push_back(filter.particles().pose(i));
  result.weights = weights(filter.particles());
  return result;
}

void expectSamePosterior(const WeightedPoses& found, const WeightedPoses& exact)
{
  for (const bool upper : {true, false})
  {
    const Moments f = moments(found, upper), e = moments(exact, upper);
    EXPECT_NEAR(f.weight, e.weight, 0.03) << upper;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(f.mean[axis], e.mean[axis], 0.1 * e.std[axis]) << upper << axis;
      EXPECT_NEAR(f.std[axis], e.std[axis], 0.1 * e.std[axis]) << upper << axis;
    }
  }
}

WeightedPoses filtered(const ParticleFilterOptions& options, const std::vector<Frame>& frames)
{
  ParticleFilter filter(options, kMap, 3, 0);
  for (const Frame& frame : frames) filter.process(frame, {badProposals});
  return particlesOf(filter);
}
}  // namespace

TEST(FilterPosterior, EqualsExactBayesFromAUniformStart)
{
  const std::vector<Frame> frames{stillFrame(1.6, 1.8, 1.4)};
  ParticleFilterOptions options = stillOptions();
  options.initial_mode = InitialMode::uniform;
  options.initial_particles = 400000;
  const WeightedPoses exact = exactPosterior(frames, 0);
  const double upper = moments(exact, true).weight;
  EXPECT_GT(upper, 0.55);  // both modes matter, and not equally
  EXPECT_LT(upper, 0.9);
  expectSamePosterior(filtered(options, frames), exact);
}

TEST(FilterPosterior, DoesNotDependOnWrongHypotheses)
{
  const std::vector<Frame> frames{stillFrame(1.6, 1.8, 1.4)};
  expectSamePosterior(filtered(stillOptions(), frames), exactPosterior(frames, 0));
}

TEST(FilterPosterior, EqualsExactBayesAfterSeveralFrames)
{
  const std::vector<Frame> frames{stillFrame(1.6, 1.8, 1.4), stillFrame(1.5, 1.9, 2.0), stillFrame(1.8, 1.7, 2.5)};
  expectSamePosterior(filtered(stillOptions(), frames), exactPosterior(frames, 0));
}

TEST(FilterPosterior, InjectedHypothesesHaveTheWeightOfTheirPrior)
{
  // The second and third frame fit another pose; how much it weighs depends on the prior of a jump.
  const std::vector<Frame> frames{stillFrame(1.6, 1.8, 1.4), stillFrame(1.3, 2.3, 1.6), stillFrame(1.2, 2.5, 2.0)};
  ParticleFilterOptions options = stillOptions();
  options.recovery.reseed_inlier_ratio = 2;  // inject before every frame ...
  options.recovery.min_interval = 0;         // ... without waiting
  options.recovery.injected_particle_share = 2;
  options.recovery.relocalization_prior = 0.3;
  options.recovery.slip_share = 0;  // the robot may be anywhere after a jump, as in the exact posterior
  expectSamePosterior(filtered(options, frames), exactPosterior(frames, 0.3));
}

TEST(FilterPosterior, AGaussianStartHasItsCovarianceEvenWithoutSpreadInOneDirection)
{
  ParticleFilterOptions options = stillOptions();
  options.initial_mode = InitialMode::gaussian;
  for (const Vector3d& std :
       {Vector3d(0.2, 0.1, 0.05), Vector3d(0, 0.1, 0.05), Vector3d(0.2, 0.1, 0), Vector3d(0, 0, 0)})
  {
    options.initial_pose = {{2, 0, 1}, std.cwiseAbs2().asDiagonal()};
    ParticleFilter filter(options, kMap, 3, 0);
    const Matrix3d found = filter.process({}, {noProposals}).modes.modes.front().pose.covariance;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::sqrt(found(i, i)), std[i], 0.03 * std[i] + 1e-6) << std.transpose();
  }
}
}  // namespace mrpt_ext::test_filter_posterior
