#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// A bearing prepared for the search: with its unit vector in sensor axes, so that no hypothesis costs
/// trigonometry.
struct ScanBearing
{
  Vector2d direction{1, 0};
  double angle = 0;  ///< [rad, CCW from the sensor's forward axis]
  double std = 0;    ///< [rad]
  int category = kAnyCategory;
  int scan = 0;       ///< index of its Scan
  int detection = 0;  ///< index among the detections of all scans, in order
};

/// True when all numbers are finite, standard deviations positive and sensor models valid.
[[nodiscard]] bool areUsable(std::span<const Scan> scans);

/// The bearings of all scans in order, without those of a category that the map does not have.
[[nodiscard]] std::vector<ScanBearing> gatherBearings(std::span<const Scan> scans);
}  // namespace mrpt_ext
