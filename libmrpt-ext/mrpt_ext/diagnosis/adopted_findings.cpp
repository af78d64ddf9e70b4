#include "mrpt_ext/diagnosis/adopted_findings.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mrpt_ext/diagnosis/noise_findings.h"
#include "mrpt_ext/diagnosis/place_deviation.h"
#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
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

std::vector<CalibrationUnknown> estimatedBy(const CalibrationChoice& choice)
{
  std::vector<CalibrationUnknown> unknowns = choice.errors;
  unknowns.insert(unknowns.end(), choice.beside.begin(), choice.beside.end());
  return unknowns;
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
}  // namespace

std::vector<CalibrationFinding> adoptedFindings(const CalibrationChoice& choice, const CalibrationData& data,
                                                const LocalizationConfig& config)
{
  CalibrationResult errors = calibrate(data.problem, estimatedBy(choice));
  if (errors.status != SolveStatus::ok) return {};
  std::vector<CalibrationFinding> adopted = placeFindings(errors, choice.errors.size(), data, config);
  errors.errors.resize(choice.errors.size());
  for (const CalibrationFinding& finding : calibrationFindings(errors, data, config))
    if (finding.why_not_observable.empty()) adopted.push_back(finding);
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
  for (CalibrationFinding& finding : placeDeviations(adopted, config.frames.sensors))
    adopted.push_back(std::move(finding));
  return adopted;
}

std::vector<CalibrationFinding> bearingOffsetFindings(const CalibrationChoice& choice, const CalibrationData& data,
                                                      const std::vector<CalibrationUnknown>& unknowns,
                                                      const LocalizationConfig& config)
{
  std::vector<CalibrationUnknown> offsets;
  std::copy_if(unknowns.begin(), unknowns.end(), std::back_inserter(offsets),
               [](const CalibrationUnknown& unknown)
               { return unknown.parameter == CalibrationParameter::bearing_offset; });
  if (offsets.empty()) return {};
  const std::vector<CalibrationUnknown> beside = estimatedBy(choice);
  std::vector<CalibrationUnknown> all = offsets;
  all.insert(all.end(), beside.begin(), beside.end());
  CalibrationResult errors = calibrate(data.problem, all);
  if (errors.status != SolveStatus::ok) return {};
  errors.errors.resize(offsets.size());
  std::vector<CalibrationFinding> found = calibrationFindings(errors, data, config);
  std::erase_if(found, [](const CalibrationFinding& finding) { return !finding.differs; });
  return found;
}
}  // namespace mrpt_ext
