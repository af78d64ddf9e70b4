#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/observations/mrpt_compatibility.h"

namespace mrpt_ext
{
/// Directions in which one camera saw landmarks at one time; one observation per camera.
class CObservationLandmarkBearings : public FixedSensorObservation
{
  DEFINE_SERIALIZABLE(CObservationLandmarkBearings, mrpt_ext)

 public:
  /// One seen landmark.
  struct Detection
  {
    std::int32_t id = mrpt::obs::INVALID_LANDMARK_ID;  ///< -1: unknown
    std::string category;                              ///< of the landmark; empty: unknown
    double bearing = 0;                                ///< [rad] CCW from the sensor's forward axis
    double std_bearing = 0;                            ///< [rad]; 0: not declared
  };

  double field_of_view = 0;  ///< [rad] full angle around the forward axis; 0: not declared
  double max_range = 0;      ///< [m] landmarks farther away are not seen; 0: not declared
  std::vector<Detection> detections;

  void getDescriptionAsText(std::ostream& o) const override;

  /// One row: N, then id, category, bearing [deg] and its standard deviation [deg] of the first 8 detections ("nan",
  /// "-": none).
  bool exportTxtSupported() const override { return true; }
  std::string exportTxtHeader() const override;
  std::string exportTxtDataRow() const override;
};
}  // namespace mrpt_ext
