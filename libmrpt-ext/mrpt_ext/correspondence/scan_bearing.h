#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// A bearing as the search uses it: a unit vector in the sensor's axes, so that no hypothesis costs trigonometry.
struct ScanBearing
{
  Vector2d direction{1, 0};
  double bearing = 0;  ///< [rad]
  double std = 0;      ///< [rad]
  int category = kAnyCategory;
  int scan = 0;       ///< index of its Scan
  int detection = 0;  ///< index among the detections of all scans, in order
};

/// Finite, with positive standard deviations and usable sensor models.
[[nodiscard]] bool areUsable(std::span<const Scan> scans);

/// The bearings of all scans, in order, without those of a category that the map does not have.
[[nodiscard]] std::vector<ScanBearing> gatherBearings(std::span<const Scan> scans);
}  // namespace mrpt_ext
