#include "mrpt_ext/filter/particle_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mrpt_ext/filter/gaussian_proposal.h"
#include "mrpt_ext/filter/particles/particle_bias.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/likelihood/compass_likelihood.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostRedrawn = 4000;  // more particles than that survive a sharp measurement anyway
constexpr double kPlaceGate = 6;            // standard deviations around a place within which its particles lie

/// In the middle of the map, where single precision is best.
Vector2d originOf(const LandmarkTable& map, const PoseRegion& region)
{
  if (map.empty()) return region.low + region.extent() / 2;
  const auto [low, high] = map.boundingBox();
  return (low + high) / 2;
}

constexpr double kFewestEffective = 4;

/// Mean and covariance of n effective particles are themselves uncertain: the covariance that is reported is free of
/// the bias of a small sample and contains the sampling error of the mean, 1 / n, and `earlier` times as much again of
/// the first mode.
void widenForSampling(FilterStep& step, double effective, double earlier)
{
  for (Mode& mode : step.modes.modes)
  {
    const double n = std::max(kFewestEffective, mode.weight * effective);
    mode.pose.covariance *= (n + 1) / (n - 1);
  }
  if (!step.modes.modes.empty()) step.modes.modes.front().pose.covariance *= 1 + earlier;
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
      trust_(slowRatioOptions(options.recovery)),
      surprise_(immediateRatioOptions(options.recovery)),
      kinds_(options.recovery),
      looks_(options.evidence.looks, options.motion, map_),
      evidence_(options.evidence, options.motion, map_),
      companions_(options.motion, options.biases),
      challenge_pause_(options.recovery.challenge_interval)
{
}

FilterStep ParticleFilter::process(const Frame& frame, const HypothesisSource& propose,
                                   std::span<const Reading> since_start, const TrajectoryHypotheses& along_way)
{
  FilterStep step;
  bool settled = true;
  if (particles_.empty())
    settled = start(frame, propose);
  else
    track(frame, propose, along_way, step);
  step.effective_ratio = normalizeWeights(particles_, options_.threads).effective_ratio;
  step.modes = findModes(particles_, options_.modes, options_.threads, std::move(mode_memory_));
  step.particles = particles_.size();
  if (!settled)
  {
    step.reason = "waiting for readings that narrow the place down";
    mode_memory_ = std::move(step.modes.mode_of);
    step.modes.mode_of.clear();
    step.effective_ratio = 1;
    step.particles = 0;
    particles_.clear();
    return step;
  }
  followEvidence(frame, step.modes);
  if (options_.companions) companions_.follow(step.modes, particles_);
  checkAgreement(frame, isUnimodal(step.modes, options_.verdict) && !monitor_.suspicious());
  step.explained_share = monitor_.average();
  const VerdictWithReason verdict = judgeStep(step);
  step.verdict = verdict.verdict;
  step.reason = verdict.reason;
  step.biases = estimateBiases(particles_);
  for (const std::string& finding :
       {kinds_.finding(), outlierText(map_, reliability_.histories()), biasText(particles_.bias_states, step.biases)})
    if (!finding.empty()) step.reason += "; " + finding;

  const double effective = step.effective_ratio * static_cast<double>(step.particles);
  const std::size_t wanted = wantedParticles(step.modes);
  const bool too_many = !options_.adaptive_size && particles_.size() > wanted;
  if (step.effective_ratio < options_.resample_below || too_many)
  {
    resample(step.modes, wanted);
    if (!since_start.empty() && !isUnimodal(step.modes, options_.verdict)) moveByReadings(since_start);
  }
  step.particles = particles_.size();
  mode_memory_ = std::move(step.modes.mode_of);
  step.modes.mode_of.clear();
  const double earlier = earlierSamplingError(frame, step.modes);
  sampling_error_ = earlier + 1 / std::max(kFewestEffective, effective);
  modes_.modes = step.modes.modes;
  widenForSampling(step, effective, earlier);
  return step;
}

KalmanState ParticleFilter::bestPlaceAfter(const OdometryMotion& motion) const
{
  const BiasModel& biases = particles_.bias_states;
  return predict(startingState(modes_.modes.front().pose, biases), biases, options_.motion, motion);
}

double ParticleFilter::earlierSamplingError(const Frame& frame, const ModeSet& modes) const
{
  if (!isUnimodal(modes_, options_.verdict) || !isUnimodal(modes, options_.verdict)) return 0;
  const GaussianPose before = modes_.modes.front().pose;
  // An error e of the prior mean is one of P M^-1 e after the measurement (M, P: covariance before and after it). With
  // e a share of the covariance of the step before, it is this times that share of P, taken as a mean over directions:
  const double M = bestPlaceAfter(frame.motion).gaussianPose().covariance.determinant();
  const double kept = before.covariance.determinant() * modes.modes.front().pose.covariance.determinant() / square(M);
  return M > 0 && kept > 0 ? sampling_error_ * std::min(1.0, std::cbrt(kept)) : 0;
}

void ParticleFilter::track(const Frame& frame, const HypothesisSource& propose, const TrajectoryHypotheses& along_way,
                           FilterStep& step)
{
  const bool one_place = isUnimodal(modes_, options_.verdict), settled = one_place && !monitor_.suspicious();
  step.reseeded = looksElsewhere() && since_injection_ + frame.motion.duration >= options_.recovery.min_interval;
  // The way does not know what was told about the start: only when nothing agrees with that any more it is asked.
  const bool asks_way = along_way && (step.reseeded || options_.initial_mode != InitialMode::gaussian);
  step.challenged = !step.reseeded && challengeDue(frame, one_place, asks_way);
  const bool injects = step.reseeded || step.challenged;
  double jump = options_.recovery.relocalization_prior;
  if (step.challenged)
  {
    jump *= options_.recovery.challenge_interval / challenge_pause_;
    challenge_pause_ = std::min(2 * challenge_pause_, options_.recovery.review_interval);
  }
  if (injects && options_.companions) companions_.watch(modes_.modes.front(), particles_);
  moveParticles(particles_, options_.motion, frame.motion, random_, options_.threads);
  walkBiases(particles_, frame.motion.duration, random_);
  since_injection_ += frame.motion.duration;
  looks_.move(frame.motion);
  const bool sought = !evidence_.proven() || !one_place;
  if (one_place && !injects)
    evidence_.observe(frame, map_, particles_);
  else
    evidence_.note(frame);
  // Where the way tells of places far off, a challenge needs no closed forms: odometry's slips remain.
  if (injects) inject(step.challenged && asks_way ? HypothesisSource() : propose, jump);
  if (injects && asks_way) believe(along_way(), frame.motion);
  Frame told = frame;
  told.readings = weighed(frame.readings, sought);
  companions_.predictAndUpdate(particles_, told, map_);
  const std::optional<KalmanState> prior = settled ? priorOfOnePlace(told) : std::nullopt;
  score(told);
  companions_.reweight(particles_);
  if (prior) redrawIfFew(*prior, told);
  if (companions_.empty()) return;
  const auto revived = static_cast<std::size_t>(
      std::ceil(options_.recovery.injected_particle_share * static_cast<double>(options_.particles)));
  normalizeWeights(particles_);
  step.revived = companions_.revive(particles_, revived, random_);
}

std::optional<KalmanState> ParticleFilter::priorOfOnePlace(const Frame& frame) const
{
  if (particles_.size() > kMostRedrawn || !companions_.empty()) return std::nullopt;
  const PoseGate gate(bestPlaceAfter(frame.motion), kPlaceGate);
  return momentsOf(particles_, [&](std::size_t i) { return gate.contains(particles_, i); });
}

void ParticleFilter::redrawIfFew(const KalmanState& prior, const Frame& frame)
{
  const auto effective = [&]
  { return normalizeWeights(particles_).effective_ratio * static_cast<double>(particles_.size()); };
  const double before = effective();
  if (before > static_cast<double>(options_.redraw_below) ||
      before > options_.resample_below * static_cast<double>(particles_.size()))
    return;
  const KalmanUpdate update = updateIterated(prior, frame, map_, particles_.bias_states);
  if (update.degrees_of_freedom == 0) return;
  ParticleSet moved = std::move(particles_);
  particles_ = drawFromKalmanProposal(moved, prior, update.state, moved.size(), random_);
  score(frame);
  if (effective() < before) particles_ = std::move(moved);
}

std::vector<Reading> ParticleFilter::weighed(const std::vector<Reading>& readings, bool sought)
{
  std::vector<Reading> fresh;
  for (const Reading& reading : readings) fresh.push_back(looks_.withoutCorrelatedBearings(reading));
  return sought ? fresh : readings;
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

std::size_t ParticleFilter::wantedParticles(const ModeSet& modes) const
{
  // Every place that may still be the right one needs enough particles for its weight to mean something.
  const bool certain = isUnimodal(modes, options_.verdict) && !monitor_.suspicious();
  const std::size_t many = std::max(options_.particles, options_.initial_particles);
  if (certain) return options_.particles;
  // ... unless companions see to that: then each place needs what a single one needs.
  const std::size_t places = options_.companions && !monitor_.suspicious() ? countPlaces(modes) : 0;
  return places > 0 ? std::min(many, places * options_.particles) : many;
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
  ParticleSet drawn = resampleByMode(particles_, modes.mode_of, options_.resampling, count, random_, options_.threads,
                                     std::move(spare_));
  spare_ = std::exchange(particles_, std::move(drawn));
  regularizeModes(particles_, modes, options_.smoothing, random_, options_.threads);
}
}  // namespace mrpt_ext
