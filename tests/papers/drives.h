#pragma once

#include "mrpt_ext/settings/settings.h"
#include "sample.h"

namespace mrpt_ext::papers
{
/// The particle filter over simulated drives, from an unknown start; one value per drive, over the full
/// seconds of its judged part at which something is seen.
struct DriveErrors
{
  Sample dx, dy, distance;  ///< mean absolute errors [m]
  Sample heading;           ///< mean absolute error [rad]
  Sample rmse;              ///< of the position [m]
  Sample bound;             ///< posterior Cramer-Rao bound at the same moments, without systematic errors [m]
  int lost = 0;             ///< drives with a judged frame more than 0.5 m off
};

/// [Drive] of the settings: drive k has the random seed k.
[[nodiscard]] DriveErrors runDrives(const Settings& settings);
}  // namespace mrpt_ext::papers
