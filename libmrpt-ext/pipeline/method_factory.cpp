#include "mrpt_ext/pipeline/method_factory.h"

#include <algorithm>
#include <functional>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/localizers/closed_form_methods.h"
#include "mrpt_ext/localizers/joined_localizer.h"
#include "mrpt_ext/localizers/odometry_localizer.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"
#include "mrpt_ext/pipeline/closest_name.h"
#include "mrpt_ext/pipeline/mrpt_filter_localizer.h"

namespace mrpt_ext
{
namespace
{
/// What kinds of measurements a log holds: decides which closed forms make sense.
struct MeasurementKinds
{
  bool known_bearing = false, known_range = false, known_point = false, unknown_bearing = false, fix = false;

  explicit MeasurementKinds(const std::vector<Frame>& frames)
  {
    for (const Frame& frame : frames)
    {
      fix = fix || !frame.fixes.empty();
      for (const Reading& reading : frame.readings)
        for (const Detection& d : reading.detections)
        {
          const bool known = d.id != kNoId;
          known_bearing = known_bearing || (known && d.bearing);
          known_range = known_range || (known && d.range);
          known_point = known_point || (known && d.bearing && d.range);
          unknown_bearing = unknown_bearing || (!known && d.bearing);
        }
    }
  }
};

using Make = std::function<std::unique_ptr<Localizer>()>;

/// A method by name; `applies` tells whether the log gives it anything.
struct MethodEntry
{
  std::string name;
  bool applies = false;
  Make make;
};

std::unique_ptr<FilterLocalizer> makeFilter(const LocalizationConfig& config, const LandmarkTable& map,
                                            std::uint64_t seed, int trial)
{
  if (config.engine == FilterEngine::mrpt) return makeMrptFilterLocalizer(config, map, seed, trial);
  return std::make_unique<ParticleFilterLocalizer>(config.filter, map, config.seed_window, seed,
                                                   static_cast<std::uint64_t>(trial));
}

std::vector<MethodEntry> closedForms(const LocalizationConfig& config, const LandmarkTable& map,
                                     const MeasurementKinds& kinds)
{
  const PoseRegion region = config.filter.region;
  const auto entry = [](const std::string& name, bool applies, ClosedFormLocalizer::Method method) {
    return MethodEntry{name, applies, [name, method] { return std::make_unique<ClosedFormLocalizer>(name, method); }};
  };
  return {
      entry("bearing_least_squares", kinds.known_bearing && map.size() >= 3,
            [&map](const Frame& frame) { return bearingLeastSquares(frame, map); }),
      entry("bearing_maximum_likelihood", kinds.known_bearing && map.size() >= 3,
            [&map](const Frame& frame) { return bearingMaximumLikelihood(frame, map); }),
      entry("interpretation_tree", kinds.unknown_bearing && map.size() >= 4,
            [&map, region](const Frame& frame) { return interpretationTree(frame, map, region); }),
      entry("two_landmark_pose", kinds.known_point && map.size() >= 2,
            [&map](const Frame& frame) { return twoLandmarkPose(frame, map); }),
      entry("range_least_squares", kinds.known_range && map.size() >= 2,
            [&map, region](const Frame& frame) { return rangeLeastSquares(frame, map, region); }),
  };
}

void checkNames(const std::vector<std::string>& wanted, const std::vector<MethodEntry>& entries)
{
  std::vector<std::string> names;
  for (const MethodEntry& entry : entries) names.push_back(entry.name);
  for (const std::string& name : wanted)
  {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto meant = closestName(name, names);
    throw configurationError("[LocalizationExperiment] methods: unknown method '" + name + "'" +
                             (meant ? ", did you mean '" + *meant + "'?" : ""));
  }
}
}  // namespace

Methods makeMethods(const LocalizationConfig& config, const LandmarkTable& map, const FrameSequence& sequence,
                    std::uint64_t seed, int trial)
{
  const MeasurementKinds kinds(sequence.frames);
  const bool moving = !config.frames.independent;
  Methods methods;
  std::vector<MethodEntry> entries{
      {"particle_filter", moving, [&] { return makeFilter(config, map, seed, trial); }},
      {"odometry", moving && !sequence.odometry.empty(),
       [&] { return std::make_unique<OdometryLocalizer>(config.filter.motion, config.filter.initial_pose); }}};
  for (MethodEntry& entry : closedForms(config, map, kinds))
  {
    entries.push_back(entry);
    if (config.join_window > 0 && moving)
      entries.push_back({entry.name + "_joined", entry.applies, [&config, make = entry.make] {
                           return std::make_unique<JoinedLocalizer>(make(), config.join_window, config.filter.motion);
                         }});
  }
  entries.push_back({"running_fix", moving && (kinds.fix || kinds.known_range),
                     [&]
                     {
                       RunningFixLocalizer::FilterHeading heading;
                       if (const FilterLocalizer* filter = methods.filter)
                         heading = [filter] { return sureHeading(*filter); };
                       return std::make_unique<RunningFixLocalizer>(config.running_fix, map, heading);
                     }});
  checkNames(config.methods, entries);
  for (const MethodEntry& entry : entries)
  {
    const bool wanted = config.methods.empty() ? entry.applies
                                               : std::find(config.methods.begin(), config.methods.end(), entry.name) !=
                                                     config.methods.end();
    if (!wanted) continue;
    methods.localizers.push_back(entry.make());
    if (entry.name == "particle_filter")
      methods.filter = static_cast<FilterLocalizer*>(methods.localizers.back().get());
  }
  return methods;
}
}  // namespace mrpt_ext
