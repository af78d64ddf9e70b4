#include "mrpt_ext/vision/hyperbolic_mirror.h"

#include <cmath>

namespace mrpt_ext
{
cv::Point2d HyperbolicMirror::pixel(double azimuth, double rho) const
{
  return {centre.x + fx * rho * std::cos(azimuth), centre.y + fy * rho * std::sin(azimuth)};
}

double HyperbolicMirror::rimRho() const
{
  const double height = std::hypot(a, b) + a * std::hypot(1.0, rim_radius / b);
  return rim_radius / height;
}

// The mirror's point on a ray through the inner focus is q = b^2 / (a - c sin(elevation)) away from it, the pinhole
// 2 c below it.
double HyperbolicMirror::rhoAt(double slope) const
{
  const double c = std::hypot(a, b);
  const double cosine = 1 / std::hypot(1.0, slope), sine = slope * cosine;
  const double q = b * b / (a - c * sine);
  return q * cosine / (2 * c + q * sine);
}

double HyperbolicMirror::slopeAt(double rho) const
{
  const double c = std::hypot(a, b), share = rho * a / b;
  const double height = (c + a * std::hypot(1.0, rho)) / (1 - share * share);  // of the mirror above the pinhole
  return (height - 2 * c) / (rho * height);
}
}  // namespace mrpt_ext
