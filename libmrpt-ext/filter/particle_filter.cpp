#include "mrpt_ext/filter/particle_filter.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/gaussian_redraw.h"
#include "mrpt_ext/filter/particle_bias.h"
#include "mrpt_ext/filter/particle_blocks.h"
#include "mrpt_ext/likelihood/compass_likelihood.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSeedInflation = 2.0;  // a proposal wider than the posterior it proposes for
constexpr double kUniformShareStart = 0.3;
constexpr double kUniformShareInjected = 0.3;
constexpr double kUniformShareRefined = 0.1;
constexpr int kRefinements = 2;             // samples drawn again from the modes of the one before
constexpr std::size_t kMostRedrawn = 4000;  // more particles than that survive a sharp measurement anyway
constexpr double kPlaceGate = 6;            // standard deviations around a place within which its particles lie

/// In the middle of the map, where single precision is best.
Vector2d originOf(const LandmarkTable& map, const PoseRegion& region)
{
  if (map.empty()) return region.low + region.extent() / 2;
  const auto [low, high] = map.boundingBox();
  return (low + high) / 2;
}

/// Symmetric square root; directions without spread are allowed.
Matrix3d squareRoot(const Matrix3d& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(covariance);
  const Matrix3d& V = eigen.eigenvectors();
  return V * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() * V.transpose();
}
}  // namespace

ParticleFilter::ParticleFilter(const ParticleFilterOptions& options, const LandmarkTable& map, std::uint64_t seed,
                               std::uint64_t stream)
    : options_(options),
      map_(map),
      random_(seed, stream),
      particles_(originOf(map, options.region), options.biases),
      reliability_(map.size(), options.reliability_prior_strength, options.max_clutter),
      monitor_(options.recovery),
      trust_(trustOptions(options.recovery)),
      surprise_(surpriseOptions(options.recovery)),
      companions_(options.motion, options.biases)
{
}

FilterStep ParticleFilter::process(const Frame& frame, const Proposer& propose)
{
  FilterStep step;
  bool settled = true;
  if (particles_.empty())
    settled = start(frame, propose);
  else
    track(frame, propose, step);
  normalizeWeights(particles_);
  step.effective_ratio = effectiveSampleRatio(particles_);
  step.modes = findModes(particles_, options_.modes, options_.threads);
  step.particles = particles_.size();
  if (!settled)
  {
    step.reason = "waiting for readings that narrow the place down";
    particles_.clear();
    return step;
  }
  if (options_.companions) companions_.follow(step.modes, particles_);
  checkAgreement(frame, isOnePlace(step.modes, options_.verdict) && !monitor_.suspicious());
  step.explained_share = monitor_.average();
  const VerdictWithReason verdict = judgeStep(step);
  step.verdict = verdict.verdict;
  step.reason = verdict.reason;

  const std::size_t wanted = wantedParticles(step.modes);
  const bool too_many = !options_.adaptive_size && particles_.size() > wanted;
  if (step.effective_ratio < options_.resample_below || too_many) resample(step.modes, wanted);
  step.particles = particles_.size();
  modes_.modes = step.modes.modes;
  return step;
}

void ParticleFilter::track(const Frame& frame, const Proposer& propose, FilterStep& step)
{
  step.reseeded = monitor_.suspicious() && since_injection_ + frame.motion.duration >= options_.recovery.min_interval;
  if (step.reseeded && options_.companions) companions_.watch(modes_.modes.front(), particles_);
  const bool settled = isOnePlace(modes_, options_.verdict) && !monitor_.suspicious();
  moveParticles(particles_, options_.motion, frame.motion, random_, options_.threads);
  walkBiases(particles_, frame.motion.duration, random_);
  since_injection_ += frame.motion.duration;
  if (step.reseeded) inject(propose);
  companions_.accompany(particles_, frame, map_);
  const std::optional<KalmanState> prior = settled ? priorOfOnePlace(frame) : std::nullopt;
  score(frame);
  companions_.divideWeight(particles_);
  if (prior) redrawIfFew(*prior, frame);
  const auto revived =
      static_cast<std::size_t>(std::ceil(options_.recovery.injected_share * static_cast<double>(options_.particles)));
  normalizeWeights(particles_);
  step.revived = companions_.revive(particles_, revived, random_);
}

std::optional<KalmanState> ParticleFilter::priorOfOnePlace(const Frame& frame) const
{
  if (particles_.size() > kMostRedrawn || !companions_.empty()) return std::nullopt;
  const KalmanState around = predict(startingState(modes_.modes.front().pose, particles_.bias_states),
                                     particles_.bias_states, options_.motion, frame.motion);
  const PoseGate gate(around, kPlaceGate);
  return momentsOf(particles_, [&](std::size_t i) { return gate.contains(particles_, i); });
}

void ParticleFilter::redrawIfFew(const KalmanState& prior, const Frame& frame)
{
  const auto effective = [&] { return effectiveSampleRatio(particles_) * static_cast<double>(particles_.size()); };
  normalizeWeights(particles_);
  const double before = effective();
  if (before > static_cast<double>(options_.redraw_below) ||
      before > options_.resample_below * static_cast<double>(particles_.size()))
    return;
  const KalmanUpdate update = updateIterated(prior, frame, map_, particles_.bias_states);
  if (update.degrees_of_freedom == 0) return;
  ParticleSet moved = std::move(particles_);
  particles_ = redrawn(moved, prior, update.state, moved.size(), random_);
  score(frame);
  normalizeWeights(particles_);
  if (effective() < before) particles_ = std::move(moved);
}

bool ParticleFilter::start(const Frame& frame, const Proposer& propose)
{
  if (options_.initial_mode == InitialMode::gaussian) return startAtKnownPose(frame);
  const std::size_t count = std::max(options_.initial_particles, options_.particles);
  const bool analytic = options_.initial_mode == InitialMode::analytic;
  const Proposal proposal = analytic && propose ? propose() : Proposal{};
  Frame evidence = frame;
  if (!proposal.joined_readings.empty()) evidence.readings = proposal.joined_readings;

  const auto draw = [&](const HypothesisSet& hypotheses, double uniform_share)
  {
    const SeedMixture mixture(hypotheses, options_.region, uniform_share, kSeedInflation, options_.seed_min_std);
    particles_ = sampleSeeds(mixture, options_.region, count, random_, particles_);
    score(evidence);
    normalizeWeights(particles_);
  };
  draw(proposal.hypotheses, kUniformShareStart);
  for (int pass = 0; analytic && pass < kRefinements; ++pass)
    draw(hypothesesOf(findModes(particles_, options_.modes)), kUniformShareRefined);
  return proposal.complete || !proposal.hypotheses.empty();
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
  score(frame);
  return true;
}

void ParticleFilter::inject(const Proposer& propose)
{
  const HypothesisSet hypotheses = propose ? propose().hypotheses : HypothesisSet{};
  const SeedMixture mixture(hypotheses, options_.region, kUniformShareInjected, kSeedInflation, options_.seed_min_std);
  since_injection_ = 0;
  const double jump = options_.recovery.prior_of_jump;
  for (float& log_w : particles_.log_weight) log_w += static_cast<float>(std::log1p(-jump));
  const std::size_t kept = particles_.size();
  const auto count =
      static_cast<std::size_t>(std::ceil(options_.recovery.injected_share * static_cast<double>(options_.particles)));
  for (std::size_t i = 0; i < count; ++i)
  {
    const Pose2 pose = mixture.sample(random_);
    const double prior = options_.region.density(pose);
    if (prior > 0) particles_.add(pose, std::log(jump * prior / (mixture.density(pose) * static_cast<double>(count))));
  }
  drawBiases(particles_, kept, random_);
}

void ParticleFilter::score(const Frame& frame)
{
  for (const Reading& reading : scoredReadings(frame)) scoreReading(reading);
  if (frame.compass) addCompassLogLikelihood(*frame.compass, particles_.poses(), particles_.log_weight);
}

void ParticleFilter::scoreReading(const Reading& reading)
{
  const LandmarkClutter clutter =
      options_.learn_reliability ? reliability_.clutter(reading.model.clutter_probability) : LandmarkClutter{};
  const ReadingScorer scorer(reading, map_, clutter, particles_.origin);
  const PoseBatch all = particles_.poses();
  const std::span<float> out = particles_.log_weight;
  forEachBlock(particles_.size(), options_.threads,
               [&](std::size_t first, std::size_t count)
               { scorer.addTo(all.block(first, count), out.subspan(first, count)); });
}

void ParticleFilter::checkAgreement(const Frame& frame, bool learn)
{
  double explained = 0, expected = 0, promised = 0;
  std::size_t detections = 0;
  for (const Reading& reading : scoredReadings(frame))
  {
    const double share = reliability_.observe(reading, map_, particles_, options_.learn_reliability && learn);
    explained += share * static_cast<double>(reading.detections.size());
    const LandmarkClutter clutter = reliability_.clutter(reading.model.clutter_probability);
    for (const Detection& detection : reading.detections)
    {
      if (!mayShowAny(detection, map_)) continue;  // not in the map: no pose could explain it
      const auto known = map_.indexOf(detection.id);
      expected += 1 - (known ? clutter[*known] : reading.model.clutter_probability);
      promised += 1 - reading.model.clutter_probability;
      ++detections;
    }
  }
  if (detections == 0) return;
  const auto count = static_cast<double>(detections);
  monitor_.observe(explained / count, expected / count, detections);
  trust_.observe(explained / count, promised / count, detections);
  surprise_.observe(explained / count, promised / count, detections);
}

VerdictWithReason ParticleFilter::judgeStep(const FilterStep& step) const
{
  const double effective = step.effective_ratio * static_cast<double>(particles_.size());
  const bool surprised = surprise_.suspicious() || monitor_.suspicious();
  const double share = surprised ? std::min(surprise_.average(), monitor_.average()) : trust_.average();
  return judge(step.modes, {share, monitor_.lost(), effective}, options_.verdict);
}

std::size_t ParticleFilter::wantedParticles(const ModeSet& modes) const
{
  // Every place that may still be the right one needs enough particles for its weight to mean something.
  const bool certain = isOnePlace(modes, options_.verdict) && !monitor_.suspicious();
  return certain ? options_.particles : std::max(options_.particles, options_.initial_particles);
}

void ParticleFilter::resample(const ModeSet& modes, std::size_t count)
{
  if (options_.adaptive_size)
  {
    // The bins that a resampled set of the present size would occupy decide how many are needed (Fox 2003).
    const std::vector<std::size_t> trial =
        drawIndices(options_.resampling, weights(particles_), particles_.size(), random_);
    const double needed =
        kldSampleSize(occupiedBins(select(particles_, trial), options_.kld), options_.kld.epsilon, options_.kld.delta);
    count = static_cast<std::size_t>(
        std::clamp(needed, static_cast<double>(options_.kld.min_size), static_cast<double>(options_.kld.max_size)));
  }
  particles_ = resampleByMode(particles_, modes.mode_of, options_.resampling, count, random_, options_.threads);
  smoothModes(particles_, modes, options_.smoothing, random_, options_.threads);
}
}  // namespace mrpt_ext
