#include "mrpt_ext/filter/initializer.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particles/particle_bias.h"
#include "mrpt_ext/filter/proposal_sampling.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/scoring_work.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUniformShare = 0.3, kUniformShareRefined = 0.1;
constexpr int kRefinements = 2, kMaxRefinements = 12;  // draws from the modes of the sample before
constexpr double kMinEffectiveSamples = 40;            // samples, to draw the next ones from
constexpr int kHalvings = 14;                          // of the interval of the exponent
constexpr std::size_t kFewDetections = 10;             // samples are saved before so many detections are left out
// In densities of a detection (likelihood/scoring_work.h): of a component of a proposal at a sample, and of a sample,
// which is ordered by place and clustered; what may be proposed and scored in one draw; of all draws.
constexpr double kCostOfComponent = 1.5, kCostOfSample = 1000;
constexpr double kMostProposed = 0.25 * kMostDensities, kMostScored = 0.5 * kMostDensities;
constexpr double kMostDrawn = 1.8 * kMostDensities;
constexpr double kMinExponent = 1e-4;
constexpr std::size_t kCostOfPower = 10;  // of a sample, in operations (work_counter.h)

/// Symmetric square root; directions without spread are allowed.
Matrix3d squareRoot(const Matrix3d& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(covariance);
  const Matrix3d& V = eigen.eigenvectors();
  return V * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() * V.transpose();
}

/// The measurements to start with: those of the window, if there is one.
Frame measurementsOf(const Frame& frame, const Proposal& proposal)
{
  Frame measurements = frame;
  if (!proposal.window_readings.empty()) measurements.readings = proposal.window_readings;
  // The newest first: they have the least error of odometry.
  std::reverse(measurements.readings.begin(), measurements.readings.end());
  return measurements;
}
}  // namespace

Initialization Initializer::initialize(const Frame& frame, const std::function<Proposal()>& closed_forms,
                                       const ParticleSet& like)
{
  if (options_.initial_mode == InitialMode::gaussian) return atKnownPose(frame, like);
  const bool analytic = options_.initial_mode == InitialMode::analytic;
  const Proposal proposal = analytic && closed_forms ? closed_forms() : Proposal{};
  model_.restart();
  const Frame measurements = model_.select(measurementsOf(frame, proposal), true);
  Initialization start{.particles = like.emptyLikeThis()};
  double exponent = draw(start, measurements, proposal.hypotheses, kUniformShare);
  start.accepted = accepts(proposal, start);
  if (!start.accepted || !analytic) return start;
  // Population Monte Carlo (Cappe et al., J. Comput. Graph. Stat. 13(4), 2004): draw again around the modes.
  const auto goes_on = [&](int pass) { return pass < kRefinements || (exponent < 1 && pass < kMaxRefinements); };
  // Another draw is about as costly as those so far.
  const auto is_affordable = [&](int pass) { return start.densities * (pass + 2) / (pass + 1) <= kMostDrawn; };
  for (int pass = 0; goes_on(pass) && is_affordable(pass); ++pass)
  {
    normalizeWeights(start.particles);
    HypothesisSet modes = hypothesesFrom(findModes(start.particles, options_.modes));
    // The modes of an annealed likelihood are blurred: the hypotheses stay, so that none of them is lost.
    if (exponent < 1) modes.insert(modes.end(), proposal.hypotheses.begin(), proposal.hypotheses.end());
    exponent = draw(start, measurements, modes, kUniformShareRefined);
  }
  return start;
}

double Initializer::draw(Initialization& start, const Frame& measurements, const HypothesisSet& hypotheses,
                         double uniform_share)
{
  const LandmarkTable& map = model_.map();
  const ProposalDistribution proposal = proposalAround(hypotheses, options_.region, uniform_share);
  const auto sample = [&](std::size_t count)
  { start.samples = sampleSeeds(proposal, options_.region, count, random_, start.particles); };
  const double cost = kCostOfComponent * proposal.overlap();
  const std::size_t many = affordableSamples(kMostProposed / std::max(1.0, cost));
  sample(many);
  const std::size_t fewer = affordableSamples(
      static_cast<double>(affordableRobots(measurements, map, start.samples.poses(), kFewDetections, kMostScored)));
  if (fewer < many) sample(fewer);
  start.measurements = affordableToScore(measurements, map, start.samples.poses(), kMostScored).value_or(measurements);
  const auto count = static_cast<double>(start.samples.size());
  start.densities += count * (cost + kCostOfSample) + scoringWork(start.measurements, map, start.samples.poses());
  start.particles = start.samples;
  model_.weight(start.measurements, start.particles);
  if (options_.initial_mode != InitialMode::analytic) return 1;
  const std::vector<float>& prior = start.samples.log_weight;
  std::vector<float>& weight = start.particles.log_weight;
  const double exponent = annealingExponent(prior, weight, kMinEffectiveSamples);
  if (exponent < 1)
    for (std::size_t i = 0; i < weight.size(); ++i)
      weight[i] = prior[i] + static_cast<float>(exponent) * (weight[i] - prior[i]);
  return exponent;
}

std::size_t Initializer::affordableSamples(double most) const
{
  const std::size_t many = std::max(options_.initial_particles, options_.particles);
  return most < static_cast<double>(many) ? std::max(options_.particles, static_cast<std::size_t>(most)) : many;
}

bool Initializer::accepts(const Proposal& proposal, Initialization& start) const
{
  if (proposal.complete) return true;
  if (proposal.hypotheses.empty()) return false;
  if (!hasAnonymous(start.measurements)) return true;
  normalizeWeights(start.particles);
  return isUnimodal(findModes(start.particles, options_.modes), options_.verdict);
}

Initialization Initializer::atKnownPose(const Frame& frame, const ParticleSet& like)
{
  Initialization start{.accepted = true, .particles = like.emptyLikeThis(), .measurements = frame};
  const Matrix3d factor = squareRoot(options_.initial_pose.covariance);
  const Pose2& mean = options_.initial_pose.mean;
  for (std::size_t i = 0; i < options_.particles; ++i)
  {
    const double a = random_.gaussian(), b = random_.gaussian(), c = random_.gaussian();
    const Vector3d offset = factor * Vector3d(a, b, c);
    start.particles.add({mean.x + offset.x(), mean.y + offset.y(), wrap(mean.phi + offset.z())}, 0);
  }
  drawBiases(start.particles, 0, random_);
  start.samples = start.particles;
  model_.weight(frame, start.particles);
  return start;
}

double annealingExponent(std::span<const float> log_prior, std::span<const float> log_weight, double effective)
{
  const auto effective_at = [&](double exponent)
  {
    const auto at = [&](std::size_t i)
    { return double{log_prior[i]} + exponent * (double{log_weight[i]} - double{log_prior[i]}); };
    double best = at(0), sum = 0, squares = 0;
    WorkCounter::add(kCostOfPower * log_prior.size());
    for (std::size_t i = 1; i < log_prior.size(); ++i) best = std::max(best, at(i));
    for (std::size_t i = 0; i < log_prior.size(); ++i)
    {
      const double w = std::exp(at(i) - best);
      sum += w;
      squares += w * w;
    }
    return sum * sum / squares;
  };
  if (log_prior.empty() || effective_at(1) >= effective) return 1;
  double low = 0, high = 1;
  for (int k = 0; k < kHalvings; ++k)
  {
    const double middle = (low + high) / 2;
    (effective_at(middle) >= effective ? low : high) = middle;
  }
  return std::max(low, kMinExponent);
}
}  // namespace mrpt_ext
