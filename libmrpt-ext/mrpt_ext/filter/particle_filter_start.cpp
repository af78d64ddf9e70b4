// Where a ParticleFilter draws particles that do not descend from others.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/hypothesis_injection.h"
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/filter/particles/particle_bias.h"
#include "mrpt_ext/filter/resample_move.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSeedInflation = 2.0;  // a proposal wider than the posterior it proposes for
constexpr double kMajority = 0.5;       // of the weight along the way
constexpr double kUniformShareStart = 0.3;
constexpr double kUniformShareInjected = 0.3;
constexpr double kUniformShareRefined = 0.1;
constexpr int kRefinements = 2, kMostRefinements = 12;   // samples drawn again from the modes of the one before
constexpr double kLeastEffective = 40;                   // samples, to draw the next ones from
const Vector3d kSharpest{0.002, 0.002, degToRad(0.02)};  // spread that a proposal has at least

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Symmetric square root; directions without spread are allowed.
Matrix3d squareRoot(const Matrix3d& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(covariance);
  const Matrix3d& V = eigen.eigenvectors();
  return V * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() * V.transpose();
}
}  // namespace

bool ParticleFilter::start(const Frame& frame, const HypothesisSource& propose)
{
  if (options_.initial_mode == InitialMode::gaussian) return startAtKnownPose(frame);
  const std::size_t count = std::max(options_.initial_particles, options_.particles);
  const bool analytic = options_.initial_mode == InitialMode::analytic;
  const Proposal proposal = analytic && propose ? propose() : Proposal{};
  Frame evidence = frame;
  if (!proposal.joined_readings.empty()) evidence.readings = proposal.joined_readings;
  // The newest first: they have suffered least from odometry.
  std::reverse(evidence.readings.begin(), evidence.readings.end());
  looks_.clear();
  evidence.readings = weighed(evidence.readings, true);

  ParticleSet samples;
  // Weights the samples with as much of the likelihood as they can tell, all of it where they lie well.
  const auto draw = [&](const ProposalDistribution& mixture)
  {
    samples = sampleSeeds(mixture, options_.region, count, random_, particles_);
    particles_ = samples;
    score(evidence);
    if (!analytic) return 1.0;
    const double exponent = annealingExponent(samples.log_weight, particles_.log_weight, kLeastEffective);
    if (exponent < 1)
      for (std::size_t i = 0; i < count; ++i)
        particles_.log_weight[i] =
            samples.log_weight[i] + static_cast<float>(exponent) * (particles_.log_weight[i] - samples.log_weight[i]);
    return exponent;
  };
  const auto around = [&](const HypothesisSet& places, double uniform_share)
  {
    return ProposalDistribution(withWideCopies(places, options_.seed_min_std), options_.region, uniform_share,
                                kSeedInflation, kSharpest);
  };
  double exponent = draw(around(proposal.hypotheses, kUniformShareStart));
  if (!mayStart(proposal, evidence)) return false;
  for (int pass = 0; analytic && (pass < kRefinements || exponent < 1) && pass < kMostRefinements; ++pass)
  {
    normalizeWeights(particles_);
    HypothesisSet places = hypothesesFrom(findModes(particles_, options_.modes));
    // While the likelihood is held back, the modes are blurred: the seeds stay, so that none of them is lost.
    if (exponent < 1) places.insert(places.end(), proposal.hypotheses.begin(), proposal.hypotheses.end());
    exponent = draw(around(places, kUniformShareRefined));
  }
  evidence_.begin(scoredReadings(evidence), map_, samples);
  return true;
}

bool ParticleFilter::mayStart(const Proposal& proposal, const Frame& evidence)
{
  if (proposal.complete) return true;
  if (proposal.hypotheses.empty() || !hasAnonymous(evidence)) return !proposal.hypotheses.empty();
  normalizeWeights(particles_);
  return isUnimodal(findModes(particles_, options_.modes), options_.verdict);
}

bool ParticleFilter::startAtKnownPose(const Frame& frame)
{
  const Matrix3d factor = squareRoot(options_.initial_pose.covariance);
  const Pose2& mean = options_.initial_pose.mean;
  for (std::size_t i = 0; i < options_.particles; ++i)
  {
    const double a = random_.gaussian(), b = random_.gaussian(), c = random_.gaussian();
    const Vector3d offset = factor * Vector3d(a, b, c);
    particles_.add({mean.x + offset.x(), mean.y + offset.y(), wrap(mean.phi + offset.z())}, 0);
  }
  drawBiases(particles_, 0, random_);
  evidence_.note(frame);
  evidence_.assume();
  score(frame);
  return true;
}

void ParticleFilter::inject(const HypothesisSource& propose, double jump)
{
  HypothesisSet hypotheses = propose ? propose().hypotheses : HypothesisSet{};
  const HypothesisSet slipped = slippedPlaces();
  hypotheses.insert(hypotheses.end(), slipped.begin(), slipped.end());
  const ProposalDistribution mixture(withWideCopies(hypotheses, options_.seed_min_std), options_.region,
                                     kUniformShareInjected, kSeedInflation, kSharpest);
  const ProposalDistribution nearby(slipped, options_.region, 0, 1, Vector3d::Zero());
  since_injection_ = 0;
  for (float& log_w : particles_.log_weight) log_w += static_cast<float>(std::log1p(-jump));
  const std::size_t kept = particles_.size();
  const auto count = static_cast<std::size_t>(
      std::ceil(options_.recovery.injected_particle_share * static_cast<double>(options_.particles)));
  const double share_of_slips = slipped.empty() ? 0 : options_.recovery.share_of_slips;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Pose2 pose = mixture.sample(random_);
    const double anywhere = options_.region.density(pose);
    if (!(anywhere > 0)) continue;
    const double prior =
        (1 - share_of_slips) * anywhere + (slipped.empty() ? 0 : share_of_slips * nearby.density(pose));
    particles_.add(pose, std::log(jump * prior / (mixture.density(pose) * static_cast<double>(count))));
  }
  drawBiases(particles_, kept, random_);
}

void ParticleFilter::believe(const HypothesisSet& along_way, const OdometryMotion& motion)
{
  since_injection_ = 0;
  if (along_way.empty() || modes_.modes.empty()) return;
  const double others = weightElsewhere(along_way, bestPlaceAfter(motion).gaussianPose().mean);
  const double share = injectedShare(others, evidence_.logOdds());
  contradicted_ = others > kMajority && share < kMajority;
  if (share < kLeastPlaceShare) return;
  normalizeWeights(particles_);
  injectHypotheses(particles_, along_way, share, options_.particles, random_);
  companions_.clear();
}

void ParticleFilter::moveByReadings(std::span<const Reading> since_start)
{
  Frame all;
  all.readings.assign(since_start.begin(), since_start.end());
  Vector2d pivot = Vector2d::Zero();
  for (const Reading& reading : since_start)
    pivot += reading.T_robot_sensor.position() / static_cast<double>(since_start.size());
  const auto posterior = [&](ParticleSet& particles)
  {
    std::swap(particles, particles_);
    std::fill(particles_.log_weight.begin(), particles_.log_weight.end(), 0.0F);
    score(all);
    addBiasLogPrior(particles_);
    for (std::size_t i = 0; i < particles_.size(); ++i)
      if (!options_.region.contains(particles_.pose(i))) particles_.log_weight[i] = -kInfinity;
    std::swap(particles, particles_);
  };
  ParticleSet moved = particles_;
  moveByPosterior(moved, findModes(moved, options_.modes, options_.threads), pivot, posterior, random_);
  particles_ = std::move(moved);
}

HypothesisSet ParticleFilter::slippedPlaces() const
{
  const RecoveryOptions& recovery = options_.recovery;
  if (!(recovery.share_of_slips > 0)) return {};
  HypothesisSet places = hypothesesFrom(findModes(particles_, options_.modes));
  for (PoseHypothesis& place : places)
    place.pose.covariance.diagonal() +=
        Vector3d(recovery.slip_std_xy, recovery.slip_std_xy, recovery.slip_std_phi).cwiseAbs2();
  return places;
}
}  // namespace mrpt_ext
