#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Point in the plane with covariance [m, m^2]; the frame is stated where it is used.
struct GaussianPoint
{
  Vector2d mean{0, 0};
  Matrix2d covariance = Matrix2d::Zero();
};
}  // namespace mrpt_ext
