#include "mrpt_ext/maps/landmark_likelihood_options.h"

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/maps/known_keys.h"

namespace mrpt_ext
{
namespace
{
/// The key's number, strictly: MRPT's own read_double() takes "nine" for 0.
double readWithin(const mrpt::config::CConfigFileBase& source, const std::string& section, const std::string& key,
                  double preset, double low, double high)
{
  const std::string text = source.read_string(section, key, shortestText(preset));
  const auto value = parseNumber(text);
  if (value && *value >= low && *value <= high) return *value;
  throw configurationError("[" + section + "] " + key + ": expected a number between " + shortestText(low) + " and " +
                           shortestText(high) + ", found '" + text + "'");
}
}  // namespace

void LandmarkLikelihoodOptions::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                                   const std::string& section)
{
  rejectUnknownKeys(source, section,
                    {"clutter_probability", "detection_probability", "default_std_bearing_deg", "default_std_range_m"});
  clutter_probability = readWithin(source, section, "clutter_probability", clutter_probability, 1e-9, 1);
  detection_probability = readWithin(source, section, "detection_probability", detection_probability, 0, 1 - 1e-9);
  default_std_bearing =
      degToRad(readWithin(source, section, "default_std_bearing_deg", radToDeg(default_std_bearing), 1e-6, 360));
  default_std_range = readWithin(source, section, "default_std_range_m", default_std_range, 1e-6, 1e6);
}

void LandmarkLikelihoodOptions::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                                 const std::string& section) const
{
  target.write(section, "clutter_probability", clutter_probability);
  target.write(section, "detection_probability", detection_probability);
  target.write(section, "default_std_bearing_deg", radToDeg(default_std_bearing));
  target.write(section, "default_std_range_m", default_std_range);
}

void LandmarkLikelihoodOptions::complete(Reading& reading) const
{
  reading.model.clutter_probability = clutter_probability;
  if (detection_probability > 0) reading.model.detection_probability = detection_probability;
  for (Detection& d : reading.detections)
  {
    if (d.std_bearing <= 0) d.std_bearing = default_std_bearing;
    if (d.std_range <= 0) d.std_range = default_std_range;
  }
}
}  // namespace mrpt_ext
