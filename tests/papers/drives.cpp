#include "drives.h"

#include <cmath>
#include <set>

#include "filter_scenario.h"
#include "mrpt_ext/experiment/tracking_bound.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr double kLost = 0.5;         // [m]
constexpr double kNearStamp = 0.005;  // [s] the bound is told at full seconds

/// Full seconds after the start at which the filter was judged.
using Seconds = std::set<long>;

Seconds addDrive(DriveErrors& errors, const FilterScenario& scenario, std::uint64_t seed, double from)
{
  Seconds judged;
  Sample dx, dy, distance, heading;
  for (const FilterSample& moment : runFilter(scenario, seed))
  {
    if (moment.time < from || std::abs(moment.time - std::round(moment.time)) > kNearStamp) continue;
    judged.insert(std::lround(moment.time));
    dx.add(std::abs(moment.error.x()));
    dy.add(std::abs(moment.error.y()));
    distance.add(moment.distance());
    heading.add(std::abs(moment.error.z()));
  }
  if (judged.empty()) return judged;
  errors.dx.add(dx.mean());
  errors.dy.add(dy.mean());
  errors.distance.add(distance.mean());
  errors.heading.add(heading.mean());
  errors.rmse.add(distance.rms());
  errors.lost += distance.quantile(1) > kLost;
  return judged;
}

void addBound(DriveErrors& errors, const FilterScenario& scenario, const Seconds& judged)
{
  const double start = scenario.truth.front().time;
  RunContext context;
  context.map = scenario.map;
  context.truth = scenario.truth;
  context.start_time = start;
  context.duration_s = scenario.truth.back().time - start;
  const std::vector<Frame>& frames = scenario.sequence.frames;
  const auto feed = [&frames, next = std::size_t{0}]() mutable
  { return next < frames.size() ? std::optional(frames[next++]) : std::nullopt; };
  const TrackingBound bound = trackingBound(context, scenario.config.filter, scenario.sequence.odometry, feed);
  Sample variance;
  for (const TrackingBound::Stamp& stamp : bound.stamps)
    if (judged.contains(std::lround(stamp.time - start))) variance.add(stamp.position_variance);
  if (variance.count() > 0) errors.bound.add(std::sqrt(variance.mean()));
}

/// Later ones win.
std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}
}  // namespace

DriveErrors runDrives(const Settings& settings)
{
  const std::string s = "Drive";
  const double from = settings.number(s, "judged_from_s");
  const std::string name = settings.text(s, "scenario");
  const auto changes = [&](const char* key) { return settings.words(s, key); };
  const auto simulation = changes("simulation"), localization = changes("localization");
  const auto without_errors = joined(simulation, changes("bound_simulation"));
  const auto own_noise = joined(localization, changes("bound_noise"));
  DriveErrors errors;
  for (std::int64_t run = 1; run <= settings.integer(s, "runs"); ++run)
  {
    const auto seed = static_cast<std::uint64_t>(run);
    const Seconds judged = addDrive(errors, playScenario(name, seed, simulation, localization), seed, from);
    addBound(errors, playScenario(name, seed, without_errors, own_noise), judged);
  }
  return errors;
}
}  // namespace mrpt_ext::papers
