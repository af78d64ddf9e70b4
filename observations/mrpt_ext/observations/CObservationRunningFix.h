#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/poses/CPose2D.h>

#include <optional>
#include <string>

#include "mrpt_ext/observations/mrpt_compatibility.h"

namespace mrpt_ext
{
/// Two ranges to one landmark, measured from two poses, and the motion between them (paper 004).
/// The stamp of the observation is that of the second range.
class CObservationRunningFix : public FixedSensorObservation
{
  DEFINE_SERIALIZABLE(CObservationRunningFix, mrpt_ext)

 public:
  bool horizontal = false;                           ///< ranges in the floor plane; otherwise a 3-D slant
  std::int32_t id = mrpt::obs::INVALID_LANDMARK_ID;  ///< of the landmark; -1: unknown
  mrpt::system::TTimeStamp first_timestamp{INVALID_TIMESTAMP};
  double first_range = 0, first_std = 0;                ///< [m] from the sensor origin
  double second_range = 0, second_std = 0;              ///< [m] from the sensor origin
  mrpt::poses::CPose2D displacement;                    ///< second robot pose in the frame of the first
  mrpt::math::CMatrixDouble33 displacement_covariance;  ///< (x, y, phi), same frame
  std::optional<double> second_bearing;                 ///< [rad] CCW from the sensor's forward axis
  double second_bearing_std = 0;                        ///< [rad]

  CObservationRunningFix() { displacement_covariance.setZero(); }

  void getDescriptionAsText(std::ostream& o) const override;

  /// One row with every field; lengths in metres, angles in degrees, covariance in m and rad; "nan": no bearing.
  bool exportTxtSupported() const override { return true; }
  std::string exportTxtHeader() const override;
  std::string exportTxtDataRow() const override;
};
}  // namespace mrpt_ext
