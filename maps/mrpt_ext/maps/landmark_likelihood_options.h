#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/config/CLoadableOptions.h>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Section `..._likelihoodOpts` of a landmarkMap2D: properties of the sensors that a log does not declare.
class LandmarkLikelihoodOptions : public mrpt::config::CLoadableOptions
{
 public:
  double clutter_probability = 0.05;   ///< share of detections that come from no landmark of the map, in (0, 1]
  double detection_probability = 0;    ///< of a landmark in view, in [0, 1); 0: missed landmarks are not scored
  double default_std_bearing = 0.035;  ///< [rad] where the log declares none (key in degrees, default 2)
  double default_std_range = 0.1;      ///< [m] where the log declares none

  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source, const std::string& section) override;
  void saveToConfigFile(mrpt::config::CConfigFileBase& target, const std::string& section) const override;

  /// Completes a reading of a log with these values. Values that the reading declares itself take precedence.
  void complete(Reading& reading) const;
};
}  // namespace mrpt_ext
