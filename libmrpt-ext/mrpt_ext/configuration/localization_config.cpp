#include "mrpt_ext/configuration/localization_config.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/configuration/bias_config.h"
#include "mrpt_ext/configuration/default_configuration.h"
#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/configuration/sensor_sections.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
const std::string kMotion = "MotionModel";
const std::string kFilter = "ParticleFilter";

MotionModel motionModel(const Settings& settings)
{
  return {.type = settings.choice(kMotion, "type", motionTypes()),
          .std_xy_per_m = settings.number(kMotion, "std_xy_per_m"),
          .std_phi_per_deg = settings.number(kMotion, "std_phi_deg_per_deg"),
          .std_phi_per_m = settings.radians(kMotion, "std_phi_deg_per_m"),
          .std_xy_per_s = settings.number(kMotion, "std_xy_per_sqrt_s"),
          .std_phi_per_s = settings.radians(kMotion, "std_phi_deg_per_sqrt_s")};
}

bool haveSameNoise(const MotionModel& a, const MotionModel& b)
{
  constexpr double kRounding = 1e-9;
  constexpr std::array kNoise{&MotionModel::std_xy_per_m, &MotionModel::std_phi_per_deg, &MotionModel::std_phi_per_m,
                              &MotionModel::std_xy_per_s, &MotionModel::std_phi_per_s};
  return std::all_of(kNoise.begin(), kNoise.end(),
                     [&](const auto member) { return std::abs(a.*member - b.*member) < kRounding; });
}

/// False for the default of MotionModel and that of the built-in configuration, also where a file repeats it, as the
/// one that a run leaves does.
bool isOdometryNoiseStated(const Settings& settings)
{
  const MotionModel stated = motionModel(settings);
  const Settings built_in =
      Settings::parse(std::string(defaultConfiguration()), kDefaultConfigurationName, settings.table());
  return !haveSameNoise(stated, {}) && !haveSameNoise(stated, motionModel(built_in));
}

constexpr const char* kMarginKey = "init_PDF_margin_m";
constexpr std::array kRegionKeys{kMarginKey, "init_PDF_min_x", "init_PDF_max_x", "init_PDF_min_y", "init_PDF_max_y"};

/// True where the box of possible positions follows from the map alone.
bool isRegionAssumed(const Settings& settings)
{
  return std::none_of(kRegionKeys.begin(), kRegionKeys.end(),
                      [&](const char* key) { return settings.optionalNumber(kExperimentSection, key).has_value(); });
}

PoseRegion poseRegion(const Settings& settings, const LandmarkTable& map)
{
  const auto [low, high] = map.boundingBox();
  const double margin = settings.optionalNumber(kExperimentSection, kMarginKey).value_or(kRegionMargin);
  PoseRegion region;
  const auto bound = [&](const char* key, double fallback)
  { return settings.optionalNumber(kExperimentSection, key).value_or(fallback); };
  region.low = {bound("init_PDF_min_x", low.x() - margin), bound("init_PDF_min_y", low.y() - margin)};
  region.high = {bound("init_PDF_max_x", high.x() + margin), bound("init_PDF_max_y", high.y() + margin)};
  for (const auto& [axis, min, max] :
       {std::tuple("x", region.low.x(), region.high.x()), std::tuple("y", region.low.y(), region.high.y())})
    if (!(min < max))
    {
      const std::string key = std::string("init_PDF_max_") + axis;
      const std::string complaint = "expected a value above init_PDF_min_" + std::string(axis);
      throw settings.isSet(kExperimentSection, key)
          ? settings.errorAt(kExperimentSection, key, complaint)
          : configurationError(settings.file().string() +
                               ": the box of possible positions is empty, set init_PDF_min_x ... "
                               "init_PDF_max_y or init_PDF_margin_m");
    }
  return region;
}

KldOptions kldOptions(const Settings& settings)
{
  const std::string s = "KLD_options";
  if (settings.integer(s, "KLD_maxSampleSize") < settings.integer(s, "KLD_minSampleSize"))
    throw settings.errorAt(s, settings.isSet(s, "KLD_maxSampleSize") ? "KLD_maxSampleSize" : "KLD_minSampleSize",
                           "expected KLD_minSampleSize <= KLD_maxSampleSize");
  return {.bin_xy = settings.number(s, "KLD_binSize_XY"),
          .bin_phi = settings.radians(s, "KLD_binSize_PHI_deg"),
          .delta = settings.number(s, "KLD_delta"),
          .epsilon = settings.number(s, "KLD_epsilon"),
          .min_size = static_cast<std::size_t>(settings.integer(s, "KLD_minSampleSize")),
          .max_size = static_cast<std::size_t>(settings.integer(s, "KLD_maxSampleSize"))};
}

GaussianPose knownStart(const Settings& settings)
{
  GaussianPose start;
  start.mean = {settings.number(kExperimentSection, "init_PDF_mean_x"),
                settings.number(kExperimentSection, "init_PDF_mean_y"),
                wrap(settings.radians(kExperimentSection, "init_PDF_mean_phi_deg"))};
  const double xy = settings.number(kExperimentSection, "init_PDF_std_xy");
  const double phi = settings.radians(kExperimentSection, "init_PDF_std_phi_deg");
  start.covariance.diagonal() << square(xy), square(xy), square(phi);
  return start;
}

ParticleFilterOptions filterOptions(const Settings& settings, const LandmarkTable& map, const ConvergenceLimits& limits)
{
  ParticleFilterOptions options;
  const bool counted = settings.hasValue(kExperimentSection, "particles_count");
  options.particles = static_cast<std::size_t>(counted ? settings.integer(kExperimentSection, "particles_count")
                                                       : settings.integer("PF_options", "sampleSize"));
  options.verified_particles =
      static_cast<std::size_t>(settings.integer(kExperimentSection, "verified_particles_count"));
  options.initial_particles = static_cast<std::size_t>(settings.integer(kExperimentSection, "initial_particles_count"));
  options.region = poseRegion(settings, map);
  options.initial_mode = settings.choice(kExperimentSection, "init_PDF_mode", initialModes());
  options.initial_pose = knownStart(settings);
  options.motion = motionModel(settings);
  options.resampling = settings.choice("PF_options", "resamplingMethod", resamplingMethods());
  options.resample_below = settings.number("PF_options", "BETA");
  options.adaptive_size = settings.flag("PF_options", "adaptiveSampleSize");
  options.kld = kldOptions(settings);
  options.modes = {.cell_xy = settings.number(kFilter, "mode_cell_m"),
                   .cell_phi = settings.radians(kFilter, "mode_cell_deg")};
  options.recovery.reseed_inlier_ratio = settings.number(kFilter, "reseed_inlier_ratio");
  options.recovery.lost_inlier_ratio = settings.number(kFilter, "lost_inlier_ratio");
  options.recovery.injected_particle_share = settings.number(kFilter, "injected_particle_share");
  options.recovery.relocalization_prior = settings.number(kFilter, "relocalization_prior");
  options.verdict = {
      .min_best_weight = settings.number(kFilter, "ok_min_weight"),
      .max_std_xy = settings.optionalNumber(kFilter, "ok_max_std_m").value_or(limits.within_m),
      .max_std_phi = settings.optionalRadians(kFilter, "ok_max_std_deg").value_or(degToRad(limits.within_deg))};
  options.mode_kalman_filters = settings.flag(kFilter, "mode_kalman_filters");
  options.kalman_proposal_below_ess = static_cast<std::size_t>(settings.integer(kFilter, "kalman_proposal_below_ess"));
  options.learn_reliability = settings.flag(kFilter, "learn_reliability");
  options.reliability_prior_strength = settings.number(kFilter, "reliability_prior");
  return options;
}

RunningFixOptions runningFixOptions(const Settings& settings, const ParticleFilterOptions& filter,
                                    const ConvergenceLimits& limits)
{
  RunningFixOptions options;
  options.heading_source = settings.choice(kExperimentSection, "heading_source", headingSources());
  if (filter.initial_mode == InitialMode::gaussian)
    options.start_heading = HeadingPrior{filter.initial_pose.mean.phi, std::sqrt(filter.initial_pose.covariance(2, 2))};
  options.region = filter.region;
  options.motion = filter.motion;
  options.limits = {limits.within_m, degToRad(limits.within_deg)};
  return options;
}
}  // namespace

LocalizationConfig localizationConfig(const Settings& settings, const LandmarkTable& map)
{
  LocalizationConfig config;
  config.seed = static_cast<std::uint64_t>(settings.integer(kExperimentSection, "random_seed"));
  config.repetitions = static_cast<int>(settings.integer(kExperimentSection, "experimentRepetitions"));
  config.limits = {.within_m = settings.number(kExperimentSection, "converged_within_m"),
                   .within_deg = settings.number(kExperimentSection, "converged_within_deg"),
                   .max_convergence_s = settings.number(kExperimentSection, "max_convergence_s")};
  config.biases = biasModel(settings);
  config.filter = filterOptions(settings, map, config.limits);
  config.odometry_noise_stated = isOdometryNoiseStated(settings);
  config.filter.biases = config.biases;
  config.region_assumed = isRegionAssumed(settings);
  config.running_fix = runningFixOptions(settings, config.filter, config.limits);
  config.engine = settings.choice(kExperimentSection, "filter_engine", filterEngines());
  config.mrpt_algorithm = settings.choice("PF_options", "PF_algorithm", mrptAlgorithms());
  if (config.engine == FilterEngine::batch && config.mrpt_algorithm != 0)
    throw settings.errorAt("PF_options", "PF_algorithm",
                           "needs filter_engine = mrpt, the batch engine has pfStandardProposal only");
  config.frames = {.window = settings.number(kExperimentSection, "frame_window_s"),
                   .independent = settings.flag(kExperimentSection, "independent_frames"),
                   .odometry = {.scale = settings.number(kMotion, "odometry_scale"),
                                .distance_per_turn = radToDeg(settings.number(kMotion, "odometry_distance_per_deg_m")),
                                .rotation_scale = settings.number(kMotion, "odometry_rotation_scale"),
                                .pivot_scale = settings.number(kMotion, "odometry_pivot_scale"),
                                .yaw = settings.radians(kMotion, "odometry_yaw_deg"),
                                .turn_per_m = settings.radians(kMotion, "odometry_turn_per_m_deg"),
                                .turn_per_s = settings.radians(kMotion, "odometry_turn_per_s_deg"),
                                .delay = settings.number(kMotion, "odometry_delay_s")},
                   .sensors = sensorConfigs(settings)};
  for (const std::string& category : settings.words(kExperimentSection, "objects"))
    config.frames.object_categories.insert(category);
  config.auto_calibrate = settings.flag(kExperimentSection, "auto_calibrate");
  config.step = settings.number(kExperimentSection, "step_s");
  config.join_window = settings.number(kExperimentSection, "join_window_s");
  config.seed_window = settings.number(kExperimentSection, "seed_window_s");
  config.lateness = settings.number(kExperimentSection, "lateness_s");
  config.odometry_wait = settings.number(kExperimentSection, "odometry_wait_s");
  config.step_budget_ms = settings.number(kExperimentSection, "step_budget_ms");
  config.methods = settings.words(kExperimentSection, "methods");
  std::erase(config.methods, "all");
  config.final_scene = settings.flag(kExperimentSection, "save_final_scene");
  config.max_detections = static_cast<std::size_t>(settings.integer(kExperimentSection, "max_detections"));
  config.max_landmarks = static_cast<std::size_t>(settings.integer(kExperimentSection, "max_landmarks"));
  config.landmark_shift_x = landmarkValues(settings, kExperimentSection, kShiftKeys[0]);
  config.landmark_shift_y = landmarkValues(settings, kExperimentSection, kShiftKeys[1]);
  config.scene_every = static_cast<std::size_t>(settings.integer(kExperimentSection, "save_scene_every"));
  return config;
}
}  // namespace mrpt_ext
