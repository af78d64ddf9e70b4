#include "mrpt_ext/vision/tags/tag_measurement.h"

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/tags/tag_facing.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLargestStdBearing = 0.3;  ///< [rad] beyond which an arc is no straight line

/// (range, bearing) and its covariance.
struct PolarPosition
{
  Eigen::Vector2d at;
  Eigen::Matrix2d covariance;
};

PolarPosition polarOf(const Eigen::Vector3d& centre, const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& level)
{
  const Eigen::Vector2d flat = (level * centre).head<2>();
  const double range = flat.norm();
  const Eigen::Vector2d along = flat / range;
  Eigen::Matrix2d by_flat;
  by_flat << along.x(), along.y(), -along.y() / range, along.x() / range;
  const Eigen::Matrix<double, 2, 3> by_centre = by_flat * level.topRows<2>();
  return {{range, std::atan2(flat.y(), flat.x())}, by_centre * covariance * by_centre.transpose()};
}

/// Mean and covariance of both, the second with this share.
PolarPosition mixtureOf(const PolarPosition& first, const PolarPosition& second, double share)
{
  const Eigen::Vector2d apart(second.at[0] - first.at[0], wrap(second.at[1] - first.at[1]));
  return {first.at + share * apart,
          (1 - share) * first.covariance + share * second.covariance + share * (1 - share) * apart * apart.transpose()};
}
}  // namespace

std::optional<TagMeasurement> measureTag(const TagCorners& corners, double edge, const PinholeCamera& camera,
                                         const TagNoise& noise)
{
  const std::vector<TagPose> poses = posesOfTag(corners, edge, camera, noise);
  if (poses.empty()) return std::nullopt;
  const auto polar = [&](const TagPose& pose)
  { return polarOf(pose.centre, pose.covariance.bottomRightCorner<3, 3>(), camera.levelAxes()); };
  PolarPosition seen = polar(poses[0]);
  if (poses.size() == 2)
  {
    const double odds = std::exp(0.5 * (poses[0].residual - poses[1].residual));
    seen = mixtureOf(seen, polar(poses[1]), odds / (1 + odds));
  }
  TagMeasurement measured;
  measured.range = seen.at[0], measured.bearing = wrap(seen.at[1]);
  measured.std_range = std::sqrt(seen.covariance(0, 0)), measured.std_bearing = std::sqrt(seen.covariance(1, 1));
  measured.correlation = seen.covariance(0, 1) / (measured.std_range * measured.std_bearing);
  measured.residual = poses[0].residual;
  measured.facing = facingOf(poses, corners, edge, camera, noise);
  const bool usable = std::isfinite(measured.bearing) && measured.std_bearing < kLargestStdBearing &&
                      measured.std_range < measured.range;
  return usable ? std::optional(measured) : std::nullopt;
}
}  // namespace mrpt_ext
