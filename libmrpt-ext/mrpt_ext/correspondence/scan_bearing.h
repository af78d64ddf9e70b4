#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// A bearing as the search uses it: a unit vector in the sensor's axes, so that no hypothesis costs trigonometry.
struct BearingReading
{
  Vector2d direction{1, 0};
  double bearing = 0;  ///< [rad]
  double std = 0;      ///< [rad]
  int kind = kAnyKind;
  int place = 0;      ///< index of its SensorPlace
  int detection = 0;  ///< index among the detections of all places, in order
};

/// Finite, with positive standard deviations and usable sensor models.
[[nodiscard]] bool areUsable(std::span<const SensorPlace> places);

/// The bearings of all places, in order, without those of a kind that the map does not have.
[[nodiscard]] std::vector<BearingReading> gatherBearings(std::span<const SensorPlace> places);
}  // namespace mrpt_ext
