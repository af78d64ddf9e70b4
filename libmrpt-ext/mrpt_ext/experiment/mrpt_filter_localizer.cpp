#include "mrpt_ext/experiment/mrpt_filter_localizer.h"

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <Eigen/Cholesky>

#include "mrpt_ext/filter/consider/consider_covariance.h"
#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"
#include "mrpt_ext/maps/CLandmarkMap2D.h"
#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/observation_conversions.h"

namespace mrpt_ext
{
namespace
{
// Pairs of a landmark and a detection, for all particles: MRPT scores one after the other, in a tenth of a microsecond.
constexpr double kMostPairsOfFrame = 6e6, kMostPairsOfDetection = 1e7;

/// Of a detection and a landmark that it may show.
double pairsIn(const Frame& frame, const LandmarkTable& map)
{
  double pairs = 0;
  for (const Reading& reading : frame.readings)
    for (const Detection& detection : reading.detections)
      pairs += detection.id == kNoId ? static_cast<double>(map.size()) : 1;
  return pairs;
}

class MrptFilterLocalizer : public FilterLocalizer
{
 public:
  MrptFilterLocalizer(const LocalizationConfig& config, const LandmarkTable& map, std::uint64_t seed)
      : options_(config.filter),
        map_(map),
        landmark_map_(std::make_shared<CLandmarkMap2D>(map)),
        reliability_(map.size(), options_.reliability_prior_strength),
        fast_ratio_(InlierRatioMonitor::fast(options_.recovery)),
        slow_ratio_(InlierRatioMonitor::slow(options_.recovery)),
        consider_(options_.motion, {}, map_, options_.givenStart())
  {
    mrpt::random::getRandomGenerator().randomize(static_cast<std::uint32_t>(seed));
    auto& pf = engine_.m_options;
    pf.PF_algorithm = static_cast<mrpt::bayes::CParticleFilter::TParticleFilterAlgorithm>(config.mrpt_algorithm);
    pf.adaptiveSampleSize = options_.adaptive_size;
    pf.BETA = 0;  // see resampleIfNeeded()
    // MRPT's adaptive size works with multinomial resampling only.
    pf.resamplingMethod = options_.adaptive_size ? mrpt::bayes::CParticleFilter::prMultinomial : resampling();
    pdf_.options.KLD_params.KLD_binSize_XY = options_.kld.bin_xy;
    pdf_.options.KLD_params.KLD_binSize_PHI = options_.kld.bin_phi;
    pdf_.options.KLD_params.KLD_delta = options_.kld.delta;
    pdf_.options.KLD_params.KLD_epsilon = options_.kld.epsilon;
    pdf_.options.KLD_params.KLD_minSampleSize = static_cast<unsigned>(options_.kld.min_size);
    pdf_.options.KLD_params.KLD_maxSampleSize = static_cast<unsigned>(options_.kld.max_size);
    auto maps = mrpt::maps::CMultiMetricMap::Create();
    maps->maps.emplace_back(landmark_map_);
    pdf_.options.metricMap = maps;
    initializeParticles();
  }

  Estimate process(const Frame& whole) override
  {
    const double work = static_cast<double>(pdf_.particlesCount()) * pairsIn(whole, map_);
    const std::optional<Frame> affordable = affordableFrame(whole, work, kMostPairsOfFrame);
    const Frame frame = consider_.withExcess(affordable ? *affordable : whole);
    const mrpt::obs::CActionCollection action = motionOf(frame.motion);
    bool moved = false;
    for (const Reading& reading : scoredReadings(frame))
    {
      landmark_map_->likelihood_options.clutter_probability = reading.model.clutter_probability;
      landmark_map_->likelihood_options.detection_probability = reading.model.detection_probability.value_or(0);
      mrpt::obs::CSensoryFrame sensory;
      if (hasRange(reading) || hasFacing(reading))
        sensory.insert(toStereoRanges(reading));
      else
        sensory.insert(toLandmarkBearings(reading));
      engine_.executeOn(pdf_, moved ? nullptr : &action, &sensory);
      resampleIfNeeded();
      moved = true;
    }
    if (!moved) engine_.executeOn(pdf_, &action, nullptr);
    evaluateParticles(frame);
    step_.detections_left_out = detectionCount(whole) - detectionCount(frame);
    return estimateFrom(step_, frame.time);
  }

  [[nodiscard]] const FilterStep& lastStep() const override { return step_; }
  [[nodiscard]] const ParticleSet& particles() const override { return particles_; }
  [[nodiscard]] std::vector<LandmarkHistory> landmarkHistories() const override { return reliability_.histories(); }

 private:
  [[nodiscard]] mrpt::bayes::CParticleFilter::TParticleResamplingAlgorithm resampling() const
  {
    using Filter = mrpt::bayes::CParticleFilter;
    switch (options_.resampling)
    {
      case ResamplingMethod::multinomial:
        return Filter::prMultinomial;
      case ResamplingMethod::residual:
        return Filter::prResidual;
      case ResamplingMethod::stratified:
        return Filter::prStratified;
      case ResamplingMethod::systematic:
        return Filter::prSystematic;
    }
    return Filter::prSystematic;
  }

  /// As executeOn() for BETA > 0, but with an explicit number of particles: MRPT 2.5.8 resets only as many weights as
  /// the number passed to performResampling(), by default none, so that the evidence of survivors would count twice.
  void resampleIfNeeded()
  {
    if (options_.adaptive_size) return;
    // The many particles of a global initialization are reduced once the verdict is ok, as in the batch engine.
    const bool too_many = pdf_.particlesCount() > options_.particles && step_.verdict == Verdict::ok;
    if (!too_many && pdf_.ESS() >= options_.resample_below) return;
    pdf_.performResampling(engine_.m_options, too_many ? options_.particles : pdf_.particlesCount());
  }

  void initializeParticles()
  {
    RandomStream random(static_cast<std::uint64_t>(mrpt::random::getRandomGenerator().drawUniform32bit()));
    const bool known = options_.initial_mode == InitialMode::gaussian;
    const Matrix3d factor = options_.initial_pose.covariance.llt().matrixL();
    // In a large map fewer, so that a detection can be scored with all of them.
    const auto affordable = static_cast<std::size_t>(kMostPairsOfDetection / static_cast<double>(map_.size() + 1));
    const std::size_t many = std::min(options_.initial_particles, affordable);
    const std::size_t count = known ? options_.particles : std::max(options_.particles, many);
    pdf_.resetDeterministic({0, 0, 0}, count);
    for (auto& particle : pdf_.m_particles)
    {
      Pose2 pose = options_.region.sample(random);
      if (known)
      {
        const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
        const Vector3d offset = factor * Vector3d(a, b, c);
        const Pose2& mean = options_.initial_pose.mean;
        pose = {mean.x + offset.x(), mean.y + offset.y(), wrap(mean.phi + offset.z())};
      }
      particle.d = {pose.x, pose.y, pose.phi};
      particle.log_w = 0;
    }
  }

  /// The increment with the Gaussian noise of our motion model, as MRPT represents it.
  [[nodiscard]] mrpt::obs::CActionCollection motionOf(const OdometryMotion& motion) const
  {
    const Vector3d std = (incrementStd(options_.motion, motion).cwiseAbs2() + motion.excess.diagonal()).cwiseSqrt();
    mrpt::obs::CActionRobotMovement2D::TMotionModelOptions noise;
    noise.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
    auto& model = noise.gaussianModel;
    model.a1 = model.a2 = model.a3 = model.a4 = 0;
    model.minStdXY = static_cast<float>(std.x());
    model.minStdPHI = static_cast<float>(std.z());
    mrpt::obs::CActionRobotMovement2D movement;
    const bool measured = options_.motion.type != MotionType::random_walk;
    const Pose2 step = measured ? motion.increment : Pose2{};
    movement.computeFromOdometry({step.x, step.y, step.phi}, noise);
    mrpt::obs::CActionCollection action;
    action.insert(movement);
    return action;
  }

  /// What the other engine states too.
  void addLastingErrors(const Frame& frame)
  {
    if (!isUnimodal(step_.modes, options_.verdict)) return consider_.restart();
    GaussianPose& best = step_.modes.modes.front().pose;
    consider_.follow(startingState(best, {}), frame, true);
    best.covariance += consider_.added();
  }

  void evaluateParticles(const Frame& frame)
  {
    particles_.clear();
    for (const auto& particle : pdf_.m_particles)
      particles_.add({particle.d.x, particle.d.y, wrap(particle.d.phi)}, particle.log_w);
    step_ = {.effective_ratio = normalizeWeights(particles_).effective_ratio};
    step_.particles = particles_.size();
    step_.modes = findModes(particles_, options_.modes);
    addLastingErrors(frame);
    for (const Reading& reading : scoredReadings(frame))
    {
      const double inlier_ratio = reliability_.observe(reading, map_, particles_, true);
      for (InlierRatioMonitor* ratio : {&fast_ratio_, &slow_ratio_})
        ratio->observe(inlier_ratio, 1 - reading.model.clutter_probability, reading.detections.size());
    }
    step_.inlier_ratio = fast_ratio_.average();
    const double effective = step_.effective_ratio * static_cast<double>(particles_.size());
    const double ratio = fast_ratio_.suspicious() ? fast_ratio_.average() : slow_ratio_.average();
    const VerdictWithReason verdict = judge(step_.modes, {ratio, fast_ratio_.lost(), effective}, options_.verdict);
    step_.verdict = verdict.verdict;
    step_.reason = verdict.reason;
  }

  ParticleFilterOptions options_;
  LandmarkTable map_;
  std::shared_ptr<CLandmarkMap2D> landmark_map_;
  mrpt::slam::CMonteCarloLocalization2D pdf_{1};
  mrpt::bayes::CParticleFilter engine_;
  LandmarkReliability reliability_;
  InlierRatioMonitor fast_ratio_, slow_ratio_;
  ConsiderCovariance consider_;
  ParticleSet particles_;
  FilterStep step_;
};
}  // namespace

std::unique_ptr<FilterLocalizer> makeMrptFilterLocalizer(const LocalizationConfig& config, const LandmarkTable& map,
                                                         std::uint64_t seed, int trial)
{
  const std::uint64_t own_seed = RandomStream(seed, static_cast<std::uint64_t>(trial)).nextBits();
  return std::make_unique<MrptFilterLocalizer>(config, map, own_seed);
}
}  // namespace mrpt_ext
