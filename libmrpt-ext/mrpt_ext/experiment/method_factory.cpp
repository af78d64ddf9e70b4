#include "mrpt_ext/experiment/method_factory.h"

#include <algorithm>

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/experiment/mrpt_filter_localizer.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/localizers/closed_form_methods.h"
#include "mrpt_ext/localizers/kalman_localizer.h"
#include "mrpt_ext/localizers/odometry_localizer.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"
#include "mrpt_ext/localizers/windowed_localizer.h"
#include "mrpt_ext/settings/name_suggestion.h"

namespace mrpt_ext
{
void AvailableMeasurements::add(const Frame& frame)
{
  fix = fix || !frame.fixes.empty();
  if (frame.compass) heading_information += 1 / square(frame.compass->std_heading);
  for (const Reading& reading : frame.readings)
  {
    const Vector2d position = reading.T_robot_sensor.position();
    separate_sensors = separate_sensors || position != frame.readings.front().T_robot_sensor.position();
    for (const Detection& d : reading.detections)
    {
      const bool identified = d.id != kNoId;
      if (d.bearing) heading_information += 1 / square(d.std_bearing);
      // A lever arm, seen from all directions: half of it is across the range on average.
      if (d.range) heading_information += 0.5 * position.squaredNorm() / square(d.std_range);
      identified_bearing = identified_bearing || (identified && d.bearing);
      identified_range = identified_range || (identified && d.range);
      identified_point = identified_point || (identified && d.bearing && d.range);
      anonymous_bearing = anonymous_bearing || (!identified && d.bearing);
    }
  }
}

namespace
{
/// Motion, biases, recovery and verdict as those of the particle filter.
KalmanBankOptions kalmanOptions(const LocalizationConfig& config, bool iterated, std::size_t max_hypotheses)
{
  KalmanBankOptions options{.max_hypotheses = max_hypotheses,
                            .iterated = iterated,
                            .motion = config.filter.motion,
                            .heading_observable = config.filter.heading_observable,
                            .biases = config.biases,
                            .recovery = config.filter.recovery,
                            .verdict = config.filter.verdict};
  if (config.filter.initial_mode == InitialMode::gaussian) options.start = config.filter.initial_pose;
  return options;
}
}  // namespace

MethodFactory::MethodFactory(const LocalizationConfig& config, const LandmarkTable& map,
                             const AvailableMeasurements& available, const std::atomic<bool>* stop)
    : config_(config), map_(map), available_(available), search_(std::make_shared<const GlobalPoseSearch>(map, stop))
{
  checkNames();
}

std::unique_ptr<FilterLocalizer> MethodFactory::makeFilter(std::uint64_t seed, int trial) const
{
  if (config_.engine == FilterEngine::mrpt) return makeMrptFilterLocalizer(config_, map_, seed, trial);
  return std::make_unique<ParticleFilterLocalizer>(config_.filter, map_, config_.seed_window, seed,
                                                   static_cast<std::uint64_t>(trial), search_);
}

std::vector<MethodFactory::Entry> MethodFactory::closedForms() const
{
  const PoseRegion region = config_.filter.region;
  const LandmarkTable& map = map_;
  const ErrorLimits limits = config_.running_fix.limits;  // a closed form like the others
  const auto entry = [&](const std::string& name, bool applies, ClosedFormLocalizer::Method method)
  {
    return Entry{name, applies,
                 [name, method, limits] { return std::make_unique<ClosedFormLocalizer>(name, method, limits); }};
  };
  return {
      entry("bearing_least_squares", available_.identified_bearing && map.size() >= 3,
            [&map](const Frame& frame) { return bearingLeastSquares(frame, map); }),
      entry("bearing_maximum_likelihood",
            available_.identified_bearing && map.size() >= (available_.separate_sensors ? 2U : 3U),
            [&map](const Frame& frame) { return bearingMaximumLikelihood(frame, map); }),
      entry("interpretation_tree", available_.anonymous_bearing && map.size() >= 3,
            [&map, region, search = search_](const Frame& frame)
            { return interpretationTree(frame, map, *search, region); }),
      entry("two_landmark_pose", available_.identified_point && map.size() >= 2,
            [&map](const Frame& frame) { return twoLandmarkPose(frame, map); }),
      entry("range_least_squares", available_.identified_range && map.size() >= 2,
            [&map, region](const Frame& frame) { return rangeLeastSquares(frame, map, region); }),
  };
}

std::vector<MethodFactory::Entry> MethodFactory::kalmanFilters() const
{
  const bool applies = !config_.frames.independent;
  const auto entry = [&](const std::string& name, bool iterated, std::size_t hypotheses)
  {
    return Entry{name, applies,
                 [this, name, iterated, hypotheses]
                 {
                   const KalmanBankOptions options = kalmanOptions(config_, iterated, hypotheses);
                   return std::make_unique<KalmanLocalizer>(name, options, map_, config_.filter.region,
                                                            config_.seed_window, search_);
                 }};
  };
  const std::size_t bank = KalmanBankOptions{}.max_hypotheses;
  return {entry("extended_kalman_filter", false, 1), entry("iterated_kalman_filter", true, 1),
          entry("kalman_filter_bank", false, bank)};
}

std::vector<MethodFactory::Entry> MethodFactory::entries(std::uint64_t seed, int trial, const Methods& methods) const
{
  const bool moving = !config_.frames.independent;
  std::vector<Entry> all{
      {"particle_filter", moving, [this, seed, trial] { return makeFilter(seed, trial); }},
      {"odometry", moving && available_.odometry,
       [this] { return std::make_unique<OdometryLocalizer>(config_.filter.motion, config_.filter.initial_pose); }}};
  for (Entry& entry : kalmanFilters()) all.push_back(std::move(entry));
  for (Entry& entry : closedForms())
  {
    all.push_back(entry);
    if (config_.join_window > 0 && moving)
      all.push_back({entry.name + "_joined", entry.applies, [this, make = entry.make] {
                       return std::make_unique<WindowedLocalizer>(make(), config_.join_window, config_.filter.motion);
                     }});
  }
  // A fix from single ranges needs the motion between them.
  all.push_back({"running_fix", moving && (available_.fix || (available_.identified_range && available_.odometry)),
                 [this, &methods]
                 {
                   RunningFixLocalizer::FilterHeading heading;
                   if (const FilterLocalizer* filter = methods.filter)
                     heading = [filter] { return confidentHeading(*filter); };
                   return std::make_unique<RunningFixLocalizer>(config_.running_fix, map_, heading);
                 }});
  return all;
}

void MethodFactory::checkNames() const
{
  std::vector<std::string> names;
  for (const Entry& entry : entries(0, 0, {})) names.push_back(entry.name);
  for (const std::string& name : config_.methods)
  {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto meant = closestName(name, names);
    throw configurationError("[LocalizationExperiment] methods: unknown method '" + name + "'" +
                             (meant ? ", did you mean '" + *meant + "'?" : ""));
  }
}

Methods MethodFactory::make(std::uint64_t seed, int trial) const
{
  Methods methods;
  if (config_.engine == FilterEngine::batch) methods.step_budget_ms = config_.step_budget_ms;
  for (const Entry& entry : entries(seed, trial, methods))
  {
    const bool selected = config_.methods.empty() ? entry.applies
                                                  : std::find(config_.methods.begin(), config_.methods.end(),
                                                              entry.name) != config_.methods.end();
    if (!selected) continue;
    methods.localizers.push_back(entry.make());
    if (entry.name == "particle_filter")
      methods.filter = static_cast<FilterLocalizer*>(methods.localizers.back().get());
  }
  return methods;
}
}  // namespace mrpt_ext
