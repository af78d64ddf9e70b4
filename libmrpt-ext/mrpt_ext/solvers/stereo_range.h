#pragma once

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A rectified stereo pair, seen as one sensor at its left camera, looking along its forward axis.
struct StereoRig
{
  double focal_length = 0;  ///< [px]
  double baseline = 0;      ///< [m]
};

/// Range and bearing with their joint uncertainty, measured by a stereo pair.
struct StereoRange
{
  SolveStatus status = SolveStatus::bad_input;
  double depth = 0;                        ///< Z, along the optical axis [m]
  double std_depth = 0;                    ///< [m]
  double range = 0;                        ///< horizontal, from the left camera [m]
  double bearing = 0;                      ///< [rad, CCW from the optical axis]
  Matrix2d covariance = Matrix2d::Zero();  ///< of (range, bearing)
  double expected_bias = 0;                ///< of the depth [m], see below
};

/// Focal length [px] of an image `width` [px] wide that spans `field_of_view` [rad]: W/2 / tan(FOV/2).
[[nodiscard]] double focalLengthFromFieldOfView(double width, double field_of_view);

/// Depth from disparity (paper 004, section on the stereo range): Z = f B / disparity, sigma_Z = Z^2 sigma_d / (f B),
/// range = Z / cos(bearing), bearing = -atan(column / f) (columns count to the right, bearings to the left).
/// `column` is the left-image column from the principal point [px]; the errors of column and disparity are taken as
/// independent. The noise is Gaussian in disparity, not in depth: the mean depth is too far by about sigma_Z^2 / Z,
/// given as `expected_bias` and not subtracted. Zero or negative disparity: `none` (at infinity or mismatched).
[[nodiscard]] StereoRange stereoRange(const StereoRig& rig, double disparity, double std_disparity, double column,
                                      double std_column);
}  // namespace mrpt_ext
