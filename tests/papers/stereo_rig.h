#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/settings/settings.h"
#include "mrpt_ext/solvers/stereo_range.h"

namespace mrpt_ext::papers
{
inline const double kRounding = 1 / std::sqrt(12.0);  ///< [px] standard deviation of rounding to whole pixels

/// The MiroSot field of paper 004 and a robot with a narrow stereo pair looking ahead.
struct StereoField
{
  Vector2d size{0, 0};
  std::vector<Vector2d> corners;  ///< of both goals
  double field_of_view = 0;       ///< [rad]
  double baseline = 0;            ///< [m]
  std::vector<double> widths;     ///< of the images [px]
  double range_scale = 1;         ///< measured / true, on average
  double min_range = 0, margin = 0;
  double std_subpixel = 0;  ///< [px]

  [[nodiscard]] StereoRig rig(double width) const
  {
    return {focalLengthFromFieldOfView(width, field_of_view), baseline};
  }
  [[nodiscard]] bool contains(const Vector2d& p, double by = 0) const
  {
    return p.x() >= by && p.y() >= by && p.x() <= size.x() - by && p.y() <= size.y() - by;
  }
};

[[nodiscard]] StereoField readStereoField(const Settings& settings);

/// A corner in the field of view, and where it is from the robot.
struct SeenCorner
{
  Vector2d corner{0, 0};
  double range = 0, bearing = 0;  ///< true
};

/// What the robot sees of this corner; nothing when it is out of view or too near.
[[nodiscard]] std::optional<SeenCorner> seen(const StereoField& field, const Pose2& robot, const Vector2d& corner);

/// All corners in view.
[[nodiscard]] std::vector<SeenCorner> allSeen(const StereoField& field, const Pose2& robot);

/// The nearest corner in view.
[[nodiscard]] std::optional<SeenCorner> nearestSeen(const StereoField& field, const Pose2& robot);

/// Anywhere in the field, not nearer to its border than the margin, any heading.
[[nodiscard]] Pose2 randomPose(const StereoField& field, RandomStream& random);

/// Measured as the paper does: whole pixels, ranges too long by the scale. Nothing beyond the last whole disparity.
[[nodiscard]] std::optional<StereoRange> wholePixelRange(const StereoField& field, double width,
                                                         const SeenCorner& corner);

/// The same between pixels, with Gaussian noise; the scale is still wrong.
[[nodiscard]] std::optional<StereoRange> subPixelRange(const StereoField& field, double width, const SeenCorner& corner,
                                                       RandomStream& random);

/// Standard deviation of the range that this disparity noise allows at best [m].
[[nodiscard]] double rangeBound(const StereoField& field, double width, double std_disparity, const SeenCorner& corner);
}  // namespace mrpt_ext::papers
