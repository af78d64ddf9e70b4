#include "mrpt_ext/diagnosis/calibration_report.h"

#include <algorithm>
#include <map>

#include "mrpt_ext/diagnosis/choice_part.h"
#include "mrpt_ext/diagnosis/error_translation.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSignificant = 3;  // standard deviations

bool differs(const CalibrationFinding& found)
{
  return found.why_not_observable.empty() && std::abs(found.estimate - found.configured) > kSignificant * found.std;
}

/// True where the value of `other` holds only beside the one that was found of `unknown`.
bool areSetTogether(const CalibrationUnknown& other, const CalibrationUnknown& unknown)
{
  return belongTogether(other, unknown) || (other.parameter == CalibrationParameter::pivot_scale &&
                                            unknown.parameter == CalibrationParameter::rotation_scale);
}

/// What each landmark has by itself: how it is stated, by id.
struct OfLandmarks
{
  CalibrationParameter parameter = CalibrationParameter::landmark_offset;
  LandmarkValues configured;
  double scale = 1;  // of a value over the error
};

/// Errors that a sensor's landmarks have by themselves, all in one line; nothing without such unknowns. They differ
/// when they are more, in their own deviations, than chance makes of so many.
std::optional<CalibrationFinding> ofLandmarks(CalibrationFinding found, OfLandmarks stated,
                                              const CalibrationResult& errors, std::size_t sensor,
                                              const CalibrationData& data)
{
  LandmarkValues& values = stated.configured;
  double count = 0, in_deviations = 0;
  for (const ParameterEstimate& error : errors.errors)
  {
    if (error.unknown.parameter != stated.parameter || error.unknown.sensor != sensor) continue;
    double& value = values[data.ids[error.unknown.landmark]];
    ++count;
    found.configured += square(value);
    value += stated.scale * error.value;
    found.estimate += square(value);
    found.std += square(stated.scale * error.std);
    if (error.std > 0) in_deviations += square(error.value / error.std);
  }
  if (count == 0) return std::nullopt;
  for (const auto& [id, value] : values)
    found.line.value +=
        (found.line.value.empty() ? "" : " ") + std::to_string(id) + ":" + fixedText(value, found.decimals);
  for (double* sum : {&found.configured, &found.estimate, &found.std}) *sum = std::sqrt(*sum / count);
  found.differs = in_deviations > count + kSignificant * std::sqrt(2 * count);
  return found;
}

std::vector<CalibrationFinding> landmarkFindings(const CalibrationResult& errors, std::size_t sensor,
                                                 const CalibrationData& data, const LocalizationConfig& config)
{
  using enum CalibrationParameter;
  const std::string& label = data.sensors[sensor];
  const SensorConfig& now = configOf(config.frames.sensors, label);
  std::vector<CalibrationFinding> findings;
  const auto add = [&](const std::string& what, const IniAssignment& line, const OfLandmarks& stated)
  {
    if (const auto found = ofLandmarks({.what = what, .unit = "m", .line = line}, stated, errors, sensor, data))
      findings.push_back(*found);
  };
  add(label + ": range offsets of its landmarks", {"Sensor_" + label, "landmark_bias_range_m", ""},
      {landmark_offset, now.landmark_bias_range, now.scale_range});
  add("map: landmarks beside their places, x", {kExperimentSection, kShiftKeys[0], ""},
      {landmark_x, config.landmark_shift_x});
  add("map: landmarks beside their places, y", {kExperimentSection, kShiftKeys[1], ""},
      {landmark_y, config.landmark_shift_y});
  return findings;
}

CalibrationFinding depthFinding(const DepthHypothesis& hypothesis, const std::string& label)
{
  return {.what = label + ": ranges are depths along its axis",
          .configured = hypothesis.configured ? 1.0 : 0,
          .estimate = hypothesis.likelier ? 1.0 : 0,
          .is_flag = true,
          .why_not_observable = hypothesis.told ? "" : "either predicts the log as well",
          .line = {"Sensor_" + label, "range_along_axis", hypothesis.likelier ? "true" : "false"},
          .differs = hypothesis.differs()};
}

/// Value of a finding with its standard deviation, and the configured one.
std::pair<std::string, std::string> valuesOf(const CalibrationFinding& found)
{
  const auto flag = [](double value) { return value != 0 ? "yes" : "no"; };
  if (found.is_flag) return {flag(found.estimate), flag(found.configured)};
  const std::string unit = found.unit.empty() ? "" : " " + found.unit;
  return {fixedText(found.estimate, found.decimals) + " +- " + fixedText(found.std, found.decimals) + unit,
          fixedText(found.configured, found.decimals) + unit};
}
}  // namespace

std::string readingsText(std::size_t bearings, std::size_t ranges)
{
  return std::to_string(bearings + ranges) + (ranges == 0     ? " bearings"
                                              : bearings == 0 ? " ranges"
                                                              : " bearings and ranges");
}

void settleLine(CalibrationFinding& found, bool differs)
{
  found.differs = differs && found.why_not_observable.empty();
  found.line.value = fixedText(found.estimate, found.decimals);
}

std::vector<CalibrationFinding> calibrationFindings(const CalibrationResult& errors, const CalibrationData& data,
                                                    const LocalizationConfig& config)
{
  std::vector<CalibrationFinding> findings;
  std::vector<ParameterEstimate> shared;  // by all landmarks
  for (const ParameterEstimate& error : errors.errors)
    if (!isOfLandmark(error.unknown.parameter)) shared.push_back(error);
  for (const ParameterEstimate& error : shared) findings.push_back(findingOf(error, errors, data, config));
  for (std::size_t k = 0; k < findings.size(); ++k)
  {
    bool set = differs(findings[k]);
    for (std::size_t j = 0; j < findings.size(); ++j)
      set = set || (areSetTogether(shared[j].unknown, shared[k].unknown) && differs(findings[j]));
    settleLine(findings[k], set);
  }
  for (std::size_t s = 0; s < data.sensors.size(); ++s)
    for (const CalibrationFinding& found : landmarkFindings(errors, s, data, config)) findings.push_back(found);
  return findings;
}

std::vector<CalibrationFinding> depthFindings(const CalibrationData& data)
{
  std::vector<CalibrationFinding> findings;
  for (const DepthHypothesis& hypothesis : data.depths)
    findings.push_back(depthFinding(hypothesis, data.sensors[hypothesis.sensor]));
  return findings;
}

std::vector<std::string> landmarkLines(const CalibrationResult& errors, const CalibrationData& data,
                                       const LandmarkTable& map)
{
  struct Count
  {
    std::size_t bearings = 0, ranges = 0, outliers = 0;
  };
  std::map<std::size_t, Count> counts;
  for (std::size_t i = 0; i < errors.misfits.size(); ++i)
  {
    const CalibrationReading& r = data.problem.readings[i];
    Count& count = counts[r.landmark_number];
    ++(r.is_range ? count.ranges : count.bearings);
    count.outliers += std::abs(errors.misfits[i]) > kOutlierMisfit;
  }
  std::vector<std::string> lines;
  for (const auto& [landmark, count] : counts)
  {
    const Landmark& of = map[landmark];
    const std::string name = of.id != kNoId
                                 ? std::to_string(of.id)
                                 : "at " + fixedText(of.position.x(), 2) + " " + fixedText(of.position.y(), 2);
    const double share = static_cast<double>(count.outliers) / static_cast<double>(count.bearings + count.ranges);
    lines.push_back("landmark " + name + ": " + readingsText(count.bearings, count.ranges) + ", " +
                    fixedText(100 * share, 1) + " % outliers");
  }
  return lines;
}

std::vector<std::string> findingsTable(const std::vector<CalibrationFinding>& findings)
{
  std::vector<std::vector<std::string>> rows{{"", "estimated", "configured", ""}};
  for (const CalibrationFinding& f : findings)
  {
    const auto [estimate, now] = valuesOf(f);
    rows.push_back({f.what, f.why_not_observable.empty() ? estimate : "not observable", now,
                    !f.why_not_observable.empty() ? f.why_not_observable
                    : f.differs                   ? "set [" + f.line.section + "] " + f.line.key + " = " + f.line.value
                    : !f.remark.empty()           ? f.remark
                                                  : "consistent"});
  }
  std::vector<std::size_t> widths(4, 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::vector<std::string> lines;
  for (const auto& row : rows)
  {
    std::string line;
    for (std::size_t c = 0; c + 1 < row.size(); ++c) line += row[c] + std::string(widths[c] - row[c].size() + 2, ' ');
    line += row.back();
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}
}  // namespace mrpt_ext
