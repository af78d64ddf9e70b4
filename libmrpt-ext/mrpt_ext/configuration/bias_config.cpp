#include "mrpt_ext/configuration/bias_config.h"

#include <array>

#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
const std::string kCommon = "Bias";
constexpr std::size_t kMaxBiases = kMaxKalmanStates - 3;
const std::string kSensorPrefix = "Sensor_";

/// How one kind of error is spelt: range_offset_std_m, range_offset_mean_m, range_offset_std_per_sqrt_s_m.
struct BiasName
{
  BiasKind kind;
  std::string name, unit, suffix;
  std::string what;
};

const std::array<BiasName, 5> kNames{{
    {BiasKind::range_offset, "range_offset", "m", "_m", "measured minus true range"},
    {BiasKind::range_scale, "range_scale", "", "", "share by which measured ranges are too long"},
    {BiasKind::bearing_offset, "bearing_offset", "deg", "_deg", "measured minus true bearing"},
    {BiasKind::distance_scale, "odometry_distance_scale", "", "",
     "share by which the true way is longer than odometry tells"},
    {BiasKind::rotation_scale, "odometry_rotation_scale", "", "",
     "share by which true turns are larger than odometry tells"},
}};

std::string meanKey(const BiasName& bias) { return bias.name + "_mean" + bias.suffix; }
std::string stdKey(const BiasName& bias) { return bias.name + "_std" + bias.suffix; }
std::string driftKey(const BiasName& bias) { return bias.name + "_std_per_sqrt_s" + bias.suffix; }

std::vector<KeySpec> keysOf(const BiasName& bias, const std::string& section, const std::string& whose)
{
  constexpr ValueRange kNotNegative{0, std::numeric_limits<double>::infinity()};
  return {
      {section,
       stdKey(bias),
       KeyType::number,
       bias.unit,
       "0",
       kNotNegative,
       {},
       "Estimate this error beside the pose (0: do not): its standard deviation at the start. It is the " + bias.what +
           ", " + whose + "."},
      {section, meanKey(bias), KeyType::number, bias.unit, "0", {}, {}, "What it is taken for at the start."},
      {section,
       driftKey(bias),
       KeyType::number,
       bias.unit,
       "0",
       kNotNegative,
       {},
       "How far it may wander: standard deviation after one second, growing with the square root of time."},
  };
}

void append(BiasModel& model, const Settings& settings, const std::string& section, const std::string& sensor)
{
  for (const BiasName& bias : kNames)
  {
    if (section != kCommon && belongsToOdometry(bias.kind)) continue;
    // What a more general section says acts on this sensor already.
    const auto value = [&](const std::string& key)
    {
      if (!settings.isSet(section, key)) return 0.0;
      return bias.unit == "deg" ? settings.radians(section, key) : settings.number(section, key);
    };
    const BiasState state{.kind = bias.kind,
                          .sensor = sensor,
                          .mean = value(meanKey(bias)),
                          .std = value(stdKey(bias)),
                          .std_per_sqrt_s = value(driftKey(bias))};
    if (state.mean != 0 || state.std > 0 || state.std_per_sqrt_s > 0) model.push_back(state);
  }
}
}  // namespace

KeyTable biasKeys()
{
  KeyTable table;
  for (const BiasName& bias : kNames)
    table.append(keysOf(
        bias, kCommon,
        belongsToOdometry(bias.kind) ? "after odometry_scale and the like were applied" : "the same for all sensors"));
  for (const BiasName& bias : kNames)
    if (!belongsToOdometry(bias.kind))
      table.append(
          keysOf(bias, kSensorPrefix + "<label>",
                 "of this sensor and of its parts after a dot together, on top of what more general sections say"));
  return table;
}

std::string biasMeanKey(BiasKind kind)
{
  for (const BiasName& bias : kNames)
    if (bias.kind == kind) return meanKey(bias);
  return {};
}

BiasModel biasModel(const Settings& settings)
{
  BiasModel model;
  append(model, settings, kCommon, "");
  for (const std::string& section : settings.sectionsMatching(kSensorPrefix))
    append(model, settings, section, section.substr(kSensorPrefix.size()));
  if (model.size() > kMaxBiases)
    throw configurationError(settings.file().string() + ": " + std::to_string(model.size()) +
                             " systematic errors are asked for in [Bias] and [Sensor_<label>], expected at most " +
                             std::to_string(kMaxBiases));
  return model;
}
}  // namespace mrpt_ext
