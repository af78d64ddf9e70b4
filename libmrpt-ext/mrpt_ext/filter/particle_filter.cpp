#include "mrpt_ext/filter/particle_filter.h"

#include <limits>
#include <utility>

#include "mrpt_ext/filter/initializer.h"
#include "mrpt_ext/filter/particles/particle_bias.h"
#include "mrpt_ext/filter/proposal_sampling.h"
#include "mrpt_ext/filter/resample_move.h"
#include "mrpt_ext/likelihood/scoring_work.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTrajectoryMajority = 0.5;            // of the weight along a trajectory
constexpr std::size_t kMaxForKalmanProposal = 20'000;  // the moments of more cost too much
constexpr double kExact = 1e9;                         // effective particles of a set with the moments of a Gaussian
constexpr double kProposalGate = 6;                    // standard deviations that the particles of a mode are within

/// In the middle of the map, where single precision is best.
Vector2d originOf(const LandmarkTable& map, const PoseRegion& region)
{
  if (map.empty()) return region.low + region.extent() / 2;
  const auto [low, high] = map.boundingBox();
  return (low + high) / 2;
}
}  // namespace

ParticleFilter::ParticleFilter(const ParticleFilterOptions& options, const LandmarkTable& map, std::uint64_t seed,
                               std::uint64_t stream)
    : options_(options),
      random_(seed, stream),
      particles_(originOf(map, options.region), options.biases),
      observation_model_(map, options.motion, options.reliability_prior_strength, options.learn_reliability,
                         options.threads),
      integrity_(options.recovery, options.verdict, options.motion, options.biases, map),
      recovery_(options.recovery),
      injector_(options.recovery, options.region, options.particles),
      mode_mixture_(options.motion, options.biases),
      resampler_(options),
      consider_(options.motion, options.biases, map, options.givenStart()),
      bias_filter_(options.motion, options.biases)
{
}

FilterStep ParticleFilter::process(const Frame& whole, const HypothesisSources& sources)
{
  if (particles_.empty()) return initialize(whole, sources);
  const std::optional<Frame> affordable = affordableToScore(whole, observation_model_.map(), particles_.poses());
  const Frame frame = consider_.withExcess(affordable ? *affordable : whole);

  // Decide on recovery, from the posterior of the last step
  const PosteriorState before = assess(frame, sources);
  const Recovery recovery = recovery_.decide(before, frame.motion.duration);
  if (recovery.due() && options_.mode_kalman_filters) mode_mixture_.retain(modes_.modes.front(), particles_);

  // While the posterior is a Gaussian, few particles stand for it
  const std::optional<KalmanState> steady = recovery.due() ? std::nullopt : steadyState();
  if (gaussian_ && !steady) growFrom(momentsOf(particles_, [](std::size_t) { return true; }));

  // Predict: x_t ~ p(x_t | x_{t-1}, u_t)
  predict(frame.motion);
  const Frame used = observation_model_.select(frame, !before.unimodal);
  std::optional<GaussianUpdate> gaussian;
  if (steady) gaussian = updated(*steady, used);

  // Test the mode, before the same measurements change it
  integrity_.test(frame, gaussian ? gaussian->samples : particles_,
                  (before.unimodal || before.ends_gap) && !recovery.due());

  // Recover: let hypotheses from elsewhere compete
  if (recovery.due()) inject(recovery, frame, sources);
  if (recovery.kind == Recovery::Kind::reseed) integrity_.doubt();

  // Weight: w_t = p(z_t | x_t)
  const bool respawned = !(gaussian && track(*gaussian, used)) && weight(used, recovery.due());

  // Estimate: the modes, never their mean
  FilterStep step = estimate(frame, recovery.kind);
  step.reseeded = recovery.kind == Recovery::Kind::reseed;
  step.verifying = recovery.kind == Recovery::Kind::verify;
  step.respawned = respawned;
  step.detections_left_out = detectionCount(whole) - detectionCount(frame);

  // Resample within the modes, where few particles have the weight
  resample(step, sources);
  return step;
}

FilterStep ParticleFilter::initialize(const Frame& frame, const HypothesisSources& sources)
{
  Initialization start =
      Initializer(options_, observation_model_, random_).initialize(frame, sources.closed_forms, particles_);
  particles_ = std::move(start.particles);
  if (!start.accepted)
  {
    FilterStep step{.heading_known = options_.heading_observable,
                    .reason = "not initialized: the measurements do not constrain the pose yet"};
    normalizeWeights(particles_, options_.threads);
    step.modes.modes = findModes(particles_, options_.modes, options_.threads).modes;
    particles_.clear();
    return step;
  }
  if (options_.initial_mode == InitialMode::gaussian)
    integrity_.startVerified(frame, options_.initial_pose);
  else
    integrity_.start(start.measurements, start.samples, options_.region);
  FilterStep step = estimate(frame, Recovery::Kind::none);
  resample(step, sources);
  return step;
}

PosteriorState ParticleFilter::assess(const Frame& frame, const HypothesisSources& sources) const
{
  return {.suspicious = integrity_.relocalizationDue(),
          .unimodal = isUnimodal(),
          .verified = integrity_.verified(),
          .anonymous = hasAnonymous(frame),
          .ends_gap = integrity_.endsGap(frame),
          .has_trajectory = usesTrajectory(sources, Recovery::Kind::verify)};
}

bool ParticleFilter::usesTrajectory(const HypothesisSources& sources, Recovery::Kind kind) const
{
  // A trajectory search does not know the known start: it is asked only when nothing agrees with that any more.
  return sources.trajectory && (kind == Recovery::Kind::reseed || options_.initial_mode != InitialMode::gaussian);
}

void ParticleFilter::predict(const OdometryMotion& motion)
{
  sampleMotion(particles_, options_.motion, motion, random_, options_.threads);
  walkBiases(particles_, motion.duration, random_);
  observation_model_.move(motion);
}

void ParticleFilter::inject(const Recovery& recovery, const Frame& frame, const HypothesisSources& sources)
{
  const bool trajectory = usesTrajectory(sources, recovery.kind);
  // The trajectory finds what is far away; beside it a verification needs the slips of odometry only.
  const bool closed_forms = sources.closed_forms && !(trajectory && recovery.kind == Recovery::Kind::verify);
  HypothesisSet proposed = closed_forms ? sources.closed_forms().hypotheses : HypothesisSet{};
  const HypothesisSet slipped = injector_.withSlip(hypothesesFrom(findModes(particles_, options_.modes)));
  injector_.inject(particles_, std::move(proposed), slipped, recovery.prior, random_);
  if (trajectory) injectTrajectory(sources.trajectory(), frame.motion);
}

void ParticleFilter::injectTrajectory(const HypothesisSet& trajectory, const OdometryMotion& motion)
{
  if (trajectory.empty() || modes_.modes.empty()) return;
  const double elsewhere = weightElsewhere(trajectory, bestModeAfter(motion).pose());
  const double share = injectedShare(elsewhere, integrity_.logOdds());
  integrity_.setContradicted(elsewhere > kTrajectoryMajority && share < kTrajectoryMajority);
  if (share < kMinInjectedWeight) return;
  normalizeWeights(particles_);
  injector_.injectTrajectory(particles_, trajectory, share, random_);
  mode_mixture_.clear();
}

std::optional<KalmanState> ParticleFilter::steadyState() const
{
  if (!isTracking() || !integrity_.verified() || !isCompact(modes_.modes.front()) || !mode_mixture_.empty() ||
      options_.adaptive_size)
    return std::nullopt;
  const PoseGate gate(startingState(modes_.modes.front().pose, options_.biases), kProposalGate);
  return momentsOf(particles_, [&](std::size_t i) { return gate.contains(particles_, i); });
}

GaussianUpdate ParticleFilter::updated(const KalmanState& steady, const Frame& frame)
{
  const KalmanState prior = mrpt_ext::predict(steady, options_.biases, options_.motion, frame.motion);
  return updateGaussian(prior, frame, observation_model_.map(), particles_, fewParticles(), random_);
}

bool ParticleFilter::track(const GaussianUpdate& update, const Frame& frame)
{
  const bool was_gaussian = gaussian_;
  gaussian_ = isConfirmed(update, frame, weigher());
  if (gaussian_)
    particles_ = drawGaussian(particles_, update.posterior, fewParticles(), random_);
  else if (was_gaussian)
    growFrom(update.prior);
  return gaussian_;
}

void ParticleFilter::growFrom(const std::optional<KalmanState>& state)
{
  if (state) particles_ = drawGaussian(particles_, *state, options_.particles, random_);
  gaussian_ = false;
}

WeightParticles ParticleFilter::weigher() const
{
  return [this](const Frame& frame, ParticleSet& particles) { observation_model_.weight(frame, particles); };
}

bool ParticleFilter::weight(const Frame& frame, bool injected)
{
  mode_mixture_.predictAndUpdate(particles_, frame, observation_model_.map());
  // The best mode says nothing about hypotheses that were injected.
  const std::optional<KalmanState> prior = injected ? std::nullopt : kalmanPrior(frame.motion);
  observation_model_.weight(frame, particles_);
  mode_mixture_.reweight(particles_);
  // Propose: where few particles would survive, draw them from a Kalman posterior instead
  if (prior)
    proposeFromKalman(particles_, *prior, frame, observation_model_.map(),
                      {options_.kalman_proposal_below_ess, options_.resample_below}, weigher(), random_);
  if (mode_mixture_.empty()) return false;
  normalizeWeights(particles_);
  return mode_mixture_.respawn(particles_, injector_.count(), random_);
}

std::optional<KalmanState> ParticleFilter::kalmanPrior(const OdometryMotion& motion) const
{
  if (!isTracking() || particles_.size() > kMaxForKalmanProposal || !mode_mixture_.empty()) return std::nullopt;
  const PoseGate gate(bestModeAfter(motion), kProposalGate);
  return momentsOf(particles_, [&](std::size_t i) { return gate.contains(particles_, i); });
}

KalmanState ParticleFilter::bestModeAfter(const OdometryMotion& motion) const
{
  const KalmanState best = startingState(modes_.modes.front().pose, options_.biases);
  return mrpt_ext::predict(best, options_.biases, options_.motion, motion);
}

FilterStep ParticleFilter::estimate(const Frame& frame, Recovery::Kind injected)
{
  FilterStep step{.heading_known = options_.heading_observable};
  step.effective_ratio = normalizeWeights(particles_, options_.threads).effective_ratio;
  step.particles = particles_.size();
  const double effective = step.effective_ratio * static_cast<double>(particles_.size());
  ModeSet stated = updateModes(frame, effective);

  // A known start is the mode under test, however imprecise it becomes, until something else was tried.
  const bool known_start = options_.initial_mode == InitialMode::gaussian && !recovery_.hasInjected();
  if (known_start)
    integrity_.followKnown(modes_, frame);
  else if (integrity_.followMode(modes_, frame))
    recovery_.resetVerification();
  if (options_.mode_kalman_filters) mode_mixture_.associate(modes_, particles_);
  integrity_.update(observation_model_.countInliers(frame, particles_, isTracking()), stated);

  // Hypotheses that are injected into a verified mode leave it few effective particles, for this frame only.
  const bool thinned =
      injected == Recovery::Kind::verify && integrity_.verified() && SamplingError::corrects(effective);
  const VerdictWithReason verdict = integrity_.verdict(
      stated, thinned ? std::numeric_limits<double>::infinity() : sampling_error_.effectiveAncestors());
  step.verdict = verdict.verdict;
  step.reason = verdict.reason;
  step.inlier_ratio = integrity_.inlierRatio();
  const auto biases = bias_filter_.estimates();
  step.biases = biases ? *biases : estimateBiases(particles_);
  for (const std::string& finding :
       {integrity_.finding(), outlierText(observation_model_.map(), reliability().histories()),
        biasText(options_.biases, step.biases),
        modes_.modes.empty() ? "" : consider_.finding(modes_.modes.front().pose.covariance)})
    if (!finding.empty()) step.reason += "; " + finding;
  step.modes = std::move(stated);
  return step;
}

ModeSet ParticleFilter::updateModes(const Frame& frame, double effective)
{
  const bool was_unimodal = isUnimodal();
  std::optional<KalmanState> only;
  if (gaussian_) only = momentsOf(particles_, [](std::size_t) { return true; });
  ModeSet found = only ? ModeSet{{{only->gaussianPose(), 1}}, std::vector<int>(particles_.size())}
                       : findModes(particles_, options_.modes, options_.threads, std::move(modes_.mode_of));
  const double remainder = was_unimodal && mrpt_ext::isUnimodal(found, options_.verdict)
                               ? SamplingError::remainder(modes_.modes.front().pose.covariance,
                                                          bestModeAfter(frame.motion).gaussianPose().covariance,
                                                          found.modes.front().pose.covariance)
                               : 0;
  modes_ = std::move(found);
  // While nothing is seen a mode is followed however imprecise it becomes: what is seen then tells odometry's noise.
  const bool unimodal = isUnimodal(), blind = detectionCount(frame) == 0 && isDominant(modes_, options_.verdict);
  if (!only && (unimodal || blind))
    only = momentsOf(particles_, [this](std::size_t i) { return modes_.mode_of[i] == 0; });
  const bool compact = unimodal && isCompact(modes_.modes.front());
  bias_filter_.follow(compact ? only : std::nullopt, frame, observation_model_.map());
  consider_.follow(std::move(only), frame, integrity_.verified());
  ModeSet stated{modes_.modes, {}};
  sampling_error_.correct(stated, gaussian_ ? kExact : effective, remainder);
  if (!stated.modes.empty()) stated.modes.front().pose.covariance += consider_.added();
  return stated;
}

std::size_t ParticleFilter::wantedParticles() const
{
  // Every mode that may be the right one needs enough particles for its weight to be meaningful.
  const std::size_t many = std::max(options_.particles, options_.initial_particles);
  if (isTracking()) return options_.particles;
  // ... unless the mode mixture takes care of the weights: then each mode needs as many as a single one.
  const std::size_t modes = options_.mode_kalman_filters && !integrity_.suspicious() ? countCompactModes(modes_) : 0;
  return modes > 0 ? std::min(many, modes * options_.particles) : many;
}

void ParticleFilter::resample(FilterStep& step, const HypothesisSources& sources)
{
  const std::size_t wanted = wantedParticles();
  const bool too_many = !options_.adaptive_size && particles_.size() > wanted;
  if (!(step.effective_ratio < options_.resample_below) && !too_many) return;
  resampler_.resample(particles_, modes_, wanted, random_);
  bias_filter_.draw(particles_, random_);
  if (!sources.since_start.empty() && !isUnimodal())
    rejuvenate(particles_, options_, sources.since_start, weigher(), random_);
  step.particles = particles_.size();
}
}  // namespace mrpt_ext
