#include "mrpt_ext/diagnosis/range_bias_report.h"

#include <algorithm>
#include <map>
#include <set>

#include "mrpt_ext/calibration/range_bias_calibration.h"
#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostEpochs = 500;  // evenly chosen: neighbouring epochs are redundant

/// Labels of sensors and ids of landmarks, by their numbers in the epochs.
struct Radios
{
  std::vector<std::string> sensors;
  std::vector<int> landmarks;
  double std_range = 0;  // [m] largest that is logged
};

template <typename Name>
std::size_t numberOf(const std::vector<Name>& names, const Name& name)
{
  return static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), name) - names.begin());
}

bool isRadioRange(const Detection& detection, const LandmarkTable& map)
{
  return detection.range && *detection.range > 0 && !detection.bearing && map.indexOf(detection.id);
}

Radios radiosOf(const Recording& recording)
{
  std::set<std::string> sensors;
  std::set<int> landmarks;
  Radios radios;
  for (const Record& record : recording.records)
    if (const auto* reading = std::get_if<Reading>(&record))
      for (const Detection& detection : reading->detections)
      {
        if (!isRadioRange(detection, recording.map)) continue;
        sensors.insert(reading->sensor);
        landmarks.insert(detection.id);
        radios.std_range = std::max(radios.std_range, detection.std_range);
      }
  radios.sensors.assign(sensors.begin(), sensors.end());
  radios.landmarks.assign(landmarks.begin(), landmarks.end());
  return radios;
}

void addRanges(const Reading& reading, const LandmarkTable& map, const Radios& radios, RadioEpoch& epoch)
{
  for (const Detection& detection : reading.detections)
  {
    if (!isRadioRange(detection, map)) continue;
    const Vector3d position = map[map.indexOf(detection.id).value()].position;
    epoch.push_back({numberOf(radios.sensors, reading.sensor), numberOf(radios.landmarks, detection.id),
                     position.head<2>(), reading.T_robot_sensor.position(),
                     reading.horizontal_range ? 0 : position.z() - reading.sensor_height, *detection.range});
  }
}

/// The ranges by stamp, of stamps at which more than one sensor ranged.
std::vector<RadioEpoch> epochsOf(const Recording& recording, const Radios& radios)
{
  std::map<double, RadioEpoch> by_time;
  for (const Record& record : recording.records)
    if (const auto* reading = std::get_if<Reading>(&record))
      addRanges(*reading, recording.map, radios, by_time[reading->time]);
  std::vector<RadioEpoch> all;
  for (auto& entry : by_time)
  {
    RadioEpoch& epoch = entry.second;
    if (std::any_of(epoch.begin(), epoch.end(), [&](const RadioRange& r) { return r.sensor != epoch[0].sensor; }))
      all.push_back(std::move(epoch));
  }
  if (all.size() <= kMostEpochs) return all;
  std::vector<RadioEpoch> chosen;
  for (std::size_t k = 0; k < kMostEpochs; ++k) chosen.push_back(std::move(all[k * all.size() / kMostEpochs]));
  return chosen;
}

std::string withStd(double value, double std) { return fixedText(value, 3) + " +- " + fixedText(std, 3) + " m"; }

RangeBiasReport report(const RangeBiases& biases, const Radios& radios)
{
  RangeBiasReport findings;
  findings.lines.push_back("radios: " + std::to_string(biases.epochs) + " epochs, std of the ranges " +
                           fixedText(biases.scatter, 3) + " m");
  std::string by_landmark;
  for (std::size_t j = 0; j < radios.landmarks.size(); ++j)
  {
    const std::string id = std::to_string(radios.landmarks[j]);
    by_landmark += (j > 0 ? " " : "") + id + ":" + fixedText(biases.landmark[j], 3);
    findings.lines.push_back("landmark " + id + ": range bias " + withStd(biases.landmark[j], biases.std_landmark[j]) +
                             " relative to the mean, " + fixedText(100 * biases.outlier_share[j], 1) + " % outliers");
  }
  for (std::size_t i = 0; i < radios.sensors.size(); ++i)
  {
    findings.lines.push_back("sensor " + radios.sensors[i] + ": range bias " +
                             withStd(biases.sensor[i], biases.std_sensor[i]));
    const std::string section = "Sensor_" + radios.sensors[i];
    findings.configuration.push_back({section, "bias_range_m", fixedText(biases.sensor[i], 3)});
    findings.configuration.push_back({section, "landmark_bias_range_m", by_landmark});
  }
  return findings;
}
}  // namespace

RangeBiasReport reportRangeBiases(const Recording& recording)
{
  const Radios radios = radiosOf(recording);
  const RangeBiases biases = estimateRangeBiases(epochsOf(recording, radios), radios.std_range);
  if (biases.status == SolveStatus::ok) return report(biases, radios);
  const std::string why = biases.status == SolveStatus::degenerate
                              ? "the ranges leave some of them undetermined"
                              : "fewer than ten epochs in which several sensors range to landmarks";
  return {{"radios: range biases not observable, " + why}, {}};
}
}  // namespace mrpt_ext
