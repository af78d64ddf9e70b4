#include "mrpt_ext/vision/stereo/stereo_camera.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kLeastSlant = 1e-3;           ///< [rad] below the horizon
constexpr double kLeastDepth = 1e-3;           ///< [m]
const double kRounding = std::sqrt(1.0 / 12);  ///< [px] standard deviation of rounding
}  // namespace

std::optional<Eigen::Vector2d> StereoCamera::floorAt(const cv::Point2d& pixel) const
{
  const double x = (pixel.x - cx) / fx, y = (pixel.y - cy) / fy;
  const double down = std::sin(pitch) + y * std::cos(pitch);
  if (!(down > kLeastSlant)) return std::nullopt;
  const double depth = height / down;
  return Eigen::Vector2d{depth * (std::cos(pitch) - y * std::sin(pitch)), -depth * x};
}

std::optional<cv::Point2d> StereoCamera::pixelOf(const Eigen::Vector2d& position, double height_above_floor) const
{
  const double up = height_above_floor - height;
  const double depth = position.x() * std::cos(pitch) - up * std::sin(pitch);
  if (!(depth > kLeastDepth)) return std::nullopt;
  const double down = -position.x() * std::sin(pitch) - up * std::cos(pitch);
  return cv::Point2d{cx - fx * position.y() / depth, cy + fy * down / depth};
}

double StereoCamera::uprightSlope(const cv::Point2d& pixel) const
{
  // The vanishing point of the vertical is (cx, cy + fy / tan(pitch)).
  const double x = (pixel.x - cx) / fx, y = (pixel.y - cy) / fy;
  const double t = std::tan(pitch);
  return fx / fy * x * t / (y * t - 1);
}

std::optional<StereoMeasurement> measureStereo(const StereoCamera& camera, const cv::Point2d& left, double disparity,
                                               double std_u, double std_disparity)
{
  if (camera.whole_pixels)
  {
    disparity = std::round(disparity);
    std_disparity = std::hypot(std_disparity, kRounding);
  }
  if (!(disparity > 0)) return std::nullopt;
  const double x = (left.x - camera.cx) / camera.fx, y = (left.y - camera.cy) / camera.fy;
  const double ahead = std::cos(camera.pitch) - y * std::sin(camera.pitch);
  if (!(ahead > 0)) return std::nullopt;
  StereoMeasurement m;
  m.depth = camera.fx * camera.baseline / disparity;
  m.position = {m.depth * ahead, -m.depth * x};
  m.range = m.position.norm();
  m.std_range = m.range * std_disparity / disparity;
  m.bearing = std::atan2(-x, ahead);
  m.std_bearing = ahead / (ahead * ahead + x * x) * std_u / camera.fx;
  return m;
}
}  // namespace mrpt_ext
