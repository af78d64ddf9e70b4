#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/facing.h"
#include "mrpt_ext/observations/mrpt_compatibility.h"

namespace mrpt_ext
{
/// Distances to landmarks, with or without direction, that one sensor (a stereo pair, a radio, a camera that sees tags)
/// measured at one time.
class CObservationStereoRanges : public FixedSensorObservation
{
  DEFINE_SERIALIZABLE(CObservationStereoRanges, mrpt_ext)

 public:
  /// One seen landmark.
  struct Detection
  {
    std::int32_t id = mrpt::obs::INVALID_LANDMARK_ID;  ///< -1: unknown
    std::string category;                              ///< of the landmark; empty: unknown
    std::optional<double> range;                       ///< [m] from the sensor origin; absent: seen, but too far
    double std_range = 0;                              ///< [m]; 0: follows from std_disparity
    double std_disparity = 0;                          ///< [px], used with `baseline_focal`; 0: not declared
    std::optional<double> bearing;                     ///< [rad] CCW from the sensor's forward axis
    double std_bearing = 0;                            ///< [rad]; 0: not declared
    std::optional<mrpt_ext::Facing> facing = {};       ///< which way the landmark faces; absent: not measured
  };

  double field_of_view = 0;   ///< [rad] full angle around the forward axis; 0: not declared
  double max_range = 0;       ///< [m] landmarks farther away are not seen; 0: not declared
  double baseline_focal = 0;  ///< [m px] stereo baseline times focal length; 0: not a stereo pair
  bool horizontal = false;    ///< ranges are measured in the floor plane; otherwise a 3-D slant
  std::vector<Detection> detections;

  /// Standard deviation of the range [m]: as declared, else from the disparity; 0 when neither is declared.
  /// With depth Z = r cos(bearing), sigma_Z = Z^2 sigma_disparity / (baseline focal), hence
  /// sigma_r = r^2 cos(bearing) sigma_disparity / (baseline focal).
  [[nodiscard]] double rangeStd(const Detection& detection) const;

  void getDescriptionAsText(std::ostream& o) const override;

  /// One row: N, then id, category, range [m] and bearing [deg], each followed by its standard deviation, of the first
  /// 8 detections, then the likelier yaw [deg] with its standard deviation of the same ("nan", "-": none).
  bool exportTxtSupported() const override { return true; }
  std::string exportTxtHeader() const override;
  std::string exportTxtDataRow() const override;
};
}  // namespace mrpt_ext
