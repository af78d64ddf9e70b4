#include "mrpt_ext/configuration/bias_config.h"

#include <cmath>

#include "mrpt_ext/geometry/bias_units.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
namespace
{
const std::string kCommon = "Bias";
const std::string kSensorPrefix = "Sensor_";
// [s] in which errors of odometry change by their prior deviation, where nothing else is said: they depend on floor,
// load and curve. Sensors keep theirs.
constexpr double kOdometryChanges = 600;

// The keys of one kind of error: range_offset_std_m, range_offset_mean_m, range_offset_std_per_sqrt_s_m.

std::string meanKey(const BiasUnit& bias) { return std::string(bias.name) + "_mean" + bias.suffix; }
std::string stdKey(const BiasUnit& bias) { return std::string(bias.name) + "_std" + bias.suffix; }
std::string driftKey(const BiasUnit& bias) { return std::string(bias.name) + "_std_per_sqrt_s" + bias.suffix; }

std::string definitionOf(BiasKind kind)
{
  switch (kind)
  {
    case BiasKind::range_offset:
      return "measured minus true range";
    case BiasKind::range_scale:
      return "relative error of ranges: measured = (1 + scale) * true";
    case BiasKind::bearing_offset:
      return "measured minus true bearing";
    case BiasKind::distance_scale:
      return "relative error of the odometry distance: true = (1 + scale) * measured";
    case BiasKind::rotation_scale:
      return "relative error of the odometry's turns: true = (1 + scale) * measured";
    case BiasKind::arc_scale:
      return "relative error of the odometry's turns while the robot drives, on top of odometry_rotation_scale";
    case BiasKind::veer:
      return "turn per metre that the odometry does not measure";
    case BiasKind::drift:
      return "turn per second that the odometry does not measure";
  }
  return {};
}

/// `scope` is a sentence that says what the error acts on.
KeyTable keysOf(const BiasUnit& bias, const std::string& section, const std::string& scope)
{
  const BiasState none;
  KeySection keys(section);
  keys.number(stdKey(bias), bias.unit, none.std, ranges::kNotNegative,
              "Prior standard deviation; above 0 it is estimated. It is the " + definitionOf(bias.kind) + ". " + scope)
      .number(meanKey(bias), bias.unit, none.mean, ranges::kAny, "Prior mean.");
  const std::string walk = "Random-walk standard deviation after one second.";
  if (belongsToOdometry(bias.kind))
    keys.number(driftKey(bias), bias.unit, kUnset, ranges::kNotNegative,
                walk + " Not set: it makes up the prior one in ten minutes.");
  else
    keys.number(driftKey(bias), bias.unit, none.std_per_sqrt_s, ranges::kNotNegative, walk);
  return keys;
}

void append(BiasModel& model, const Settings& settings, const std::string& section, const std::string& sensor)
{
  for (const BiasUnit& bias : kBiasUnits)
  {
    if (section != kCommon && belongsToOdometry(bias.kind)) continue;
    // What a more general section sets acts on this sensor already.
    const auto value = [&](const std::string& key)
    {
      if (!settings.isSet(section, key)) return 0.0;
      return settings.number(section, key) / bias.factor;
    };
    BiasState state{.kind = bias.kind,
                    .sensor = sensor,
                    .mean = value(meanKey(bias)),
                    .std = value(stdKey(bias)),
                    .std_per_sqrt_s = value(driftKey(bias))};
    if (belongsToOdometry(bias.kind) && !settings.isSet(section, driftKey(bias)))
      state.std_per_sqrt_s = state.std / std::sqrt(kOdometryChanges);
    if (state.mean != 0 || state.std > 0 || state.std_per_sqrt_s > 0) model.push_back(state);
  }
}
}  // namespace

KeyTable biasKeys()
{
  KeyTable table;
  for (const BiasUnit& bias : kBiasUnits)
    table.append(keysOf(bias, kCommon,
                        belongsToOdometry(bias.kind) ? "What is left after odometry_scale and the like were applied."
                                                     : "The same for all sensors."));
  for (const BiasUnit& bias : kBiasUnits)
    if (!belongsToOdometry(bias.kind))
      table.append(
          keysOf(bias, kSensorPrefix + "<label>",
                 "Of this sensor and of those whose label continues this one after a dot, on top of [Bias] and "
                 "of more general sections."));
  return table;
}

std::string biasMeanKey(BiasKind kind) { return meanKey(unitOf(kind)); }

std::string biasStdKey(BiasKind kind) { return stdKey(unitOf(kind)); }

BiasModel biasModel(const Settings& settings)
{
  BiasModel model;
  append(model, settings, kCommon, "");
  for (const std::string& section : settings.sectionsMatching(kSensorPrefix))
    append(model, settings, section, section.substr(kSensorPrefix.size()));
  if (model.size() > kMaxBiases)
    throw configurationError(settings.file().string() + ": " + std::to_string(model.size()) +
                             " systematic errors in [Bias] and [Sensor_<label>], expected at most " +
                             std::to_string(kMaxBiases));
  return model;
}
}  // namespace mrpt_ext
