#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/likelihood/prepared_detection.h"
#include "mrpt_ext/likelihood/sensor_tile.h"
#include "mrpt_ext/likelihood/visibility_limits.h"

namespace mrpt_ext
{
/// Bounds of the sensor poses of some tiles: a circle, a sector of headings, and the systematic errors.
struct SensorBounds
{
  double x = 0, y = 0, radius = 0;                      ///< [m] from the origin
  double heading = 0, half_turn = kPi;                  ///< [rad] of the sensors
  double bearing_heading = 0, bearing_half_turn = kPi;  ///< [rad] that bearings refer to
  double scale_low = 1, scale_high = 1;                 ///< of ranges
  double shift_low = 0, shift_high = 0;                 ///< [m] of ranges
};

[[nodiscard]] SensorBounds boundsOf(std::span<const SensorTile> tiles);

/// Whether a landmark is within the visibility limits.
enum class InView : std::uint8_t
{
  no,    ///< of no sensor
  some,  ///< possibly of some
  all    ///< of all, at visibility 1
};

/// Visibility culling for sensors close to each other: which landmarks of the map can be in view, and which can have
/// given a detection. Conservative: a landmark that is left out is out of view of every sensor.
class LandmarkCulling
{
 public:
  LandmarkCulling(const LandmarkTable& map, const ScoringFrame& frame);

  /// Prepares the queries for these sensors.
  void update(const SensorBounds& bounds, const VisibilityLimits& limits);

  [[nodiscard]] const std::vector<InView>& inView() const { return in_view_; }

  /// Of the `candidates` (positions in the map) those not out of view whose prediction may lie within `cut` standard
  /// deviations of the detection, appended to `near`.
  void findNear(const Detection& detection, double cut, std::span<const std::uint32_t> candidates,
                std::vector<std::uint32_t>& near) const;

 private:
  void classify(const VisibilityLimits& limits);

  // Per landmark: position, squared rise, largest variance of its position and the sensor's [m^2].
  std::vector<float> x_, y_, rise2_, spread_;
  // As seen from the middle of the sensors: direction [rad], half width it covers from all of them, ranges.
  std::vector<float> direction_, half_width_, nearest_, farthest_, bearing_spread_;
  std::vector<InView> in_view_;
  SensorBounds bounds_;
};
}  // namespace mrpt_ext
