#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include <optional>
#include <string>

namespace mrpt_ext
{
/// Two ranges to one landmark, measured from two poses, and the motion between them (paper 004).
/// The stamp of the observation is that of the second range.
class CObservationRunningFix : public mrpt::obs::CObservation
{
  DEFINE_SERIALIZABLE(CObservationRunningFix, mrpt_ext)

 public:
  mrpt::poses::CPose3D sensor_pose;                  ///< on the robot
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

  void getSensorPose(mrpt::poses::CPose3D& pose) const override { pose = sensor_pose; }
  void setSensorPose(const mrpt::poses::CPose3D& pose) override { sensor_pose = pose; }
  void getDescriptionAsText(std::ostream& o) const override;

  /// One row with every field; lengths in metres, angles in degrees, covariance in m and rad; "nan": no bearing.
  bool exportTxtSupported() const override { return true; }
  std::string exportTxtHeader() const override;
  std::string exportTxtDataRow() const override;
};
}  // namespace mrpt_ext
