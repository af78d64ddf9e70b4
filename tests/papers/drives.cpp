#include "drives.h"

#include "filter_scenario.h"
#include "mrpt_ext/pipeline/tracking_bound.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr double kLost = 0.5;  // [m]

void addDrive(DriveErrors& errors, const FilterScenario& scenario, std::uint64_t seed, double from)
{
  Sample dx, dy, distance, heading;
  for (const FilterMoment& moment : runFilter(scenario, seed))
  {
    if (moment.time < from) continue;
    dx.add(std::abs(moment.error.x()));
    dy.add(std::abs(moment.error.y()));
    distance.add(moment.distance());
    heading.add(std::abs(moment.error.z()));
  }
  if (distance.count() == 0) return;
  errors.dx.add(dx.mean());
  errors.dy.add(dy.mean());
  errors.distance.add(distance.mean());
  errors.heading.add(heading.mean());
  errors.rmse.add(distance.rms());
  errors.lost += distance.quantile(1) > kLost;
}

void addBound(DriveErrors& errors, const FilterScenario& scenario, double from)
{
  LocalizationInput input;
  input.config = scenario.config;
  input.sequence = scenario.sequence;
  input.context.map = scenario.map;
  input.context.truth = scenario.truth;
  input.context.start_time = scenario.truth.front().time;
  input.context.duration_s = scenario.truth.back().time - scenario.truth.front().time;
  const LimitScore limit = limitFrom(trackingBound(input), scenario.truth.front().time + from);
  if (limit.position_rmse_m) errors.bound.add(*limit.position_rmse_m);
}
}  // namespace

DriveErrors runDrives(const Settings& settings)
{
  const std::string s = "Drive";
  const double from = settings.number(s, "judged_from_s");
  DriveErrors errors;
  for (std::int64_t run = 1; run <= settings.integer(s, "runs"); ++run)
  {
    const auto seed = static_cast<std::uint64_t>(run);
    const std::string name = settings.text(s, "scenario");
    addDrive(errors, playScenario(name, seed), seed, from);
    const auto without_errors = words(settings.text(s, "bound_simulation"));
    addBound(errors, playScenario(name, seed, without_errors, words(settings.text(s, "bound_noise"))), from);
  }
  return errors;
}
}  // namespace mrpt_ext::papers
