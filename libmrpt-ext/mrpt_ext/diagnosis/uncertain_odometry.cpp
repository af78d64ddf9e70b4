#include "mrpt_ext/diagnosis/uncertain_odometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "mrpt_ext/configuration/bias_config.h"
#include "mrpt_ext/diagnosis/delay_without_map.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/bias_units.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTold = 3;                  // standard deviations
constexpr double kTypicalRange = 0.25;       // of the diagonal of the map
constexpr double kScaleStd = 0.05;           // of distances and of turns
constexpr double kFollowing = 0.15;          // [s]
constexpr std::size_t kMostReadings = 5000;  // of a quarter of an hour and more
constexpr double kVeerStd = degToRad(2.0);   // [rad/m]

bool hasErrorsOfOdometry(const BiasModel& biases)
{
  return std::any_of(biases.begin(), biases.end(), [](const BiasState& bias) { return belongsToOdometry(bias.kind); });
}

bool isAnonymous(const AvailableMeasurements& log)
{
  return log.anonymous_bearing && !log.identified_bearing && !log.identified_range && !log.fix;
}

/// With detections, each at its own stamp, those of a sensor kFollowing apart at least: less tells nothing of a delay.
std::vector<Reading> firstReadings(const LocalizationInput& input)
{
  FrameOptions by_stamp = input.config.frames;
  by_stamp.window = 0;
  std::map<std::string, double> last;  // by sensor
  std::vector<Reading> readings;
  const FrameStream frames = streamOf(input, by_stamp);
  while (const auto frame = frames())
  {
    for (const Reading& reading : frame->readings)
    {
      const auto before = last.find(reading.sensor);
      if (reading.detections.empty() || (before != last.end() && reading.time - before->second < kFollowing)) continue;
      last[reading.sensor] = reading.time;
      readings.push_back(reading);
    }
    if (readings.size() >= kMostReadings) break;
  }
  return readings;
}

CalibratedValue stateOf(BiasKind kind, double std)
{
  return {"Bias", biasStdKey(kind), shortestText(std * unitOf(kind).factor)};
}
}  // namespace

std::vector<CalibratedValue> uncertainOdometry(const LocalizationInput& input)
{
  const LocalizationConfig& config = input.config;
  const AvailableMeasurements& log = input.log.available;
  if (config.frames.independent || !log.odometry || config.filter.motion.type == MotionType::random_walk ||
      !isAnonymous(log) || hasErrorsOfOdometry(config.biases))
    return {};
  std::vector<CalibratedValue> values{stateOf(BiasKind::distance_scale, kScaleStd),
                                      stateOf(BiasKind::rotation_scale, kScaleStd), stateOf(BiasKind::veer, kVeerStd)};
  if (config.biases.size() + values.size() > kMaxBiases) return {};
  const auto [low, high] = input.context.map.boundingBox();
  const auto late = delayWithoutMap(firstReadings(input), input.log.overview.odometry,
                                    kTypicalRange * std::max(1.0, (high - low).norm()));
  if (late && std::abs(late->delay) > kTold * late->std)
    values.push_back(
        {"MotionModel", "odometry_delay_s", fixedText(config.frames.odometry.delay + late->delay, 3), late->std});
  return values;
}
}  // namespace mrpt_ext
