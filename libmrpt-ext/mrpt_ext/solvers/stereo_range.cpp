#include "mrpt_ext/solvers/stereo_range.h"

namespace mrpt_ext
{
double focalLengthFromFieldOfView(double width, double field_of_view)
{
  return 0.5 * width / std::tan(0.5 * field_of_view);
}

StereoRange stereoRange(const StereoRig& rig, double disparity, double std_disparity, double column, double std_column)
{
  StereoRange result;
  const Vector3d noise(std_disparity, std_column, column);
  if (!std::isfinite(disparity) || !noise.allFinite()) return result;
  if (!(rig.focal_length > 0 && rig.baseline > 0) || std_disparity < 0 || std_column < 0) return result;
  if (disparity <= 0)
  {
    result.status = SolveStatus::none;
    return result;
  }
  const double f = rig.focal_length;
  const double strength = f * rig.baseline;
  const double stretch = std::hypot(1.0, column / f);  // 1 / cos(bearing)
  result.status = SolveStatus::ok;
  result.depth = strength / disparity;
  result.std_depth = square(result.depth) * std_disparity / strength;
  result.expected_bias = square(result.std_depth) / result.depth;
  result.bearing = -std::atan2(column, f);
  result.range = result.depth * stretch;

  Matrix2d J;                                               // d (range, bearing) / d (depth, column)
  J << stretch, result.depth * column / (f * f * stretch),  //
      0, -1.0 / (f * square(stretch));
  result.covariance = J * Vector2d(square(result.std_depth), square(std_column)).asDiagonal() * J.transpose();
  return result;
}
}  // namespace mrpt_ext
