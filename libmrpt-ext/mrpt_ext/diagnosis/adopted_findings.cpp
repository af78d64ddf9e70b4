#include "mrpt_ext/diagnosis/adopted_findings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "mrpt_ext/diagnosis/choice_part.h"
#include "mrpt_ext/diagnosis/noise_findings.h"
#include "mrpt_ext/diagnosis/place_deviation.h"
#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTold = 2;         // standard deviations of an error
constexpr double kMostTurned = 10;  // [deg] that the axes of odometry may be
constexpr double kRounding = 1e-6;  // [m], [rad]

/// Decimals that keep two significant digits of a value, at least `decimals`.
int decimalsFor(double value, int decimals)
{
  return std::max(decimals, value > 0 ? 1 - static_cast<int>(std::floor(std::log10(value))) : 0);
}

/// True when the noise that `line` sets is chosen; `sensors`: labels, by number.
bool isChosen(const IniAssignment& line, const NoiseChoice& noise, const std::vector<std::string>& sensors)
{
  for (std::size_t s = 0; s < sensors.size(); ++s)
  {
    if (line.section != "Sensor_" + sensors[s]) continue;
    return (line.key == "std_bearing_deg" && noise.bearings[s]) || (line.key == "std_range_m" && noise.ranges[s]) ||
           (line.key == "clutter_probability" && noise.outliers[s]);
  }
  return line.section == "MotionModel" && noise.odometry[line.key == "std_xy_per_m" ? position_noise : heading_noise];
}

/// The chosen errors that the whole log tells, and what is estimated beside them.
struct ToldErrors
{
  CalibrationResult found;  // the chosen ones first
  std::size_t chosen = 0;   // number of them
};

/// Number of the least significant error that the log does not tell, if any. Errors that are only told together count
/// by the more significant one; those of landmarks are not looked at one by one.
std::optional<std::size_t> untold(const ToldErrors& errors)
{
  const std::vector<ParameterEstimate>& found = errors.found.errors;
  std::optional<std::size_t> weakest;
  double least = kTold;
  for (std::size_t k = 0; k < errors.chosen; ++k)
  {
    if (isOfLandmark(found[k].unknown.parameter)) continue;
    const bool is_told =
        std::any_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(errors.chosen),
                    [&](const ParameterEstimate& other)
                    { return belongTogether(other.unknown, found[k].unknown) && strengthOf(other) >= kTold; });
    if (is_told || strengthOf(found[k]) >= least) continue;
    least = strengthOf(found[k]);
    weakest = k;
  }
  return weakest;
}

ToldErrors toldErrors(const CalibrationChoice& choice, const CalibrationProblem& problem)
{
  std::vector<CalibrationUnknown> candidates = choice.errors;
  candidates.insert(candidates.end(), choice.beside.begin(), choice.beside.end());
  std::vector<std::size_t> chosen(choice.errors.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  for (;;)
  {
    std::vector<CalibrationUnknown> unknowns;
    for (const std::size_t k : chosen) unknowns.push_back(candidates[k]);
    for (const std::size_t k : estimatedBeside(chosen, candidates)) unknowns.push_back(candidates[k]);
    ToldErrors told{calibrate(problem, unknowns), chosen.size()};
    if (told.found.status != SolveStatus::ok) return told;
    const std::optional<std::size_t> weakest = untold(told);
    if (!weakest) return told;
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(*weakest));
  }
}

/// Lever arms that differ, of those estimated beside the first `chosen` errors.
std::vector<CalibrationFinding> placeFindings(CalibrationResult errors, std::size_t chosen, const CalibrationData& data,
                                              const LocalizationConfig& config)
{
  errors.errors.erase(errors.errors.begin(), errors.errors.begin() + static_cast<std::ptrdiff_t>(chosen));
  std::erase_if(errors.errors, [](const ParameterEstimate& error) { return !isLeverArm(error.unknown.parameter); });
  std::vector<CalibrationFinding> places = calibrationFindings(errors, data, config);
  std::erase_if(places, [](const CalibrationFinding& finding) { return !finding.differs; });
  return places;
}

/// True when something in a recording depends on axes of the robot beside those of its only sensor of bearings.
bool hasOwnAxes(const CalibrationData& data, const std::vector<CalibrationFinding>& adopted)
{
  const std::vector<CalibrationReading>& readings = data.problem.readings;
  const auto is_placed = [](const CalibrationReading& r)
  { return r.T_robot_sensor.position().norm() + std::abs(r.T_robot_sensor.phi) >= kRounding; };
  return data.compass || sensorsWithBearings(data).size() != 1 ||
         std::any_of(readings.begin(), readings.end(), is_placed) ||
         std::any_of(adopted.begin(), adopted.end(),
                     [](const CalibrationFinding& finding) { return isOfLeverArm(finding) && finding.differs; });
}

/// Bearings tell the axes of a sensor from those of odometry, and not which of the two are the robot's. A robot drives
/// along its own, so the sensor is turned, unless it is the robot: then odometry is.
void attributeBearingOffset(std::vector<CalibrationFinding>& adopted, const CalibrationData& data,
                            const LocalizationConfig& config)
{
  const auto found =
      std::find_if(adopted.begin(), adopted.end(),
                   [](const CalibrationFinding& finding) { return finding.line.key == "bias_bearing_deg"; });
  if (found == adopted.end() || hasOwnAxes(data, adopted)) return;
  const std::string label = *sensorsWithBearings(data).begin();
  const double scale = configOf(config.frames.sensors, label).scale_bearing;
  const double offset = (found->estimate - found->configured) / scale, before = radToDeg(config.frames.odometry.yaw);
  if (std::abs(offset) > kMostTurned) return;
  *found = {.what = "odometry: x axis further left than that of " + label,
            .unit = "deg",
            .configured = before,
            .estimate = before + offset,
            .std = found->std / scale,
            .decimals = found->decimals,
            .line = {"MotionModel", "odometry_yaw_deg", ""}};
  settleLine(*found, true);
}
}  // namespace

std::vector<CalibrationFinding> adoptedFindings(const CalibrationChoice& choice, const CalibrationData& data,
                                                const LocalizationConfig& config)
{
  auto [errors, chosen] = toldErrors(choice, data.problem);
  if (errors.status != SolveStatus::ok) return {};
  std::vector<CalibrationFinding> adopted = placeFindings(errors, chosen, data, config);
  errors.errors.resize(chosen);
  for (const CalibrationFinding& finding : calibrationFindings(errors, data, config))
    if (finding.why_not_observable.empty()) adopted.push_back(finding);
  attributeBearingOffset(adopted, data, config);
  for (const CalibrationFinding& finding : depthFindings(data))
    if (finding.differs) adopted.push_back(finding);
  for (CalibrationFinding& finding : noiseFindings(errors, data, config))
  {
    if (!finding.why_not_observable.empty() || !(finding.estimate > 0) ||
        !isChosen(finding.line, choice.noise, data.sensors))
      continue;
    finding.decimals = decimalsFor(finding.estimate, finding.decimals);
    finding.line.value = fixedText(finding.estimate, finding.decimals);
    adopted.push_back(finding);
  }
  for (CalibrationFinding& finding : placeDeviations(adopted, data, config.frames.sensors))
    adopted.push_back(std::move(finding));
  return adopted;
}
}  // namespace mrpt_ext
