#include "stereo_rig.h"

#include <algorithm>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::papers
{
namespace
{
std::optional<StereoRange> scaled(const StereoField& field, StereoRange range)
{
  if (range.status != SolveStatus::ok) return std::nullopt;
  range.range *= field.range_scale;
  return range;
}

double disparity(const StereoField& field, double width, const SeenCorner& corner)
{
  const StereoRig rig = field.rig(width);
  return rig.focal_length * rig.baseline / (corner.range * std::cos(corner.bearing));
}

double column(const StereoField& field, double width, const SeenCorner& corner)
{
  return -field.rig(width).focal_length * std::tan(corner.bearing);
}
}  // namespace

StereoField readStereoField(const Settings& settings)
{
  const std::string s = "Stereo";
  StereoField field;
  const auto size = settings.numbers(s, "field"), corners = settings.numbers(s, "corners");
  field.size = {size.at(0), size.at(1)};
  for (std::size_t i = 0; i + 1 < corners.size(); i += 2) field.corners.emplace_back(corners[i], corners[i + 1]);
  field.field_of_view = settings.radians(s, "field_of_view_deg");
  field.baseline = settings.number(s, "baseline_m");
  field.widths = settings.numbers(s, "widths_px");
  field.range_scale = settings.number(s, "range_scale");
  field.min_range = settings.number(s, "min_range_m");
  field.margin = settings.number(s, "margin_m");
  field.std_subpixel = settings.number(s, "std_subpixel_px");
  return field;
}

std::optional<SeenCorner> seen(const StereoField& field, const Pose2& robot, const Vector2d& corner)
{
  const SeenCorner s{corner, predictRange(robot, corner), predictBearing(robot, corner)};
  if (s.range < field.min_range || 2 * std::abs(s.bearing) > field.field_of_view) return std::nullopt;
  return s;
}

std::vector<SeenCorner> allSeen(const StereoField& field, const Pose2& robot)
{
  std::vector<SeenCorner> all;
  for (const Vector2d& corner : field.corners)
    if (const auto s = seen(field, robot, corner)) all.push_back(*s);
  return all;
}

std::optional<SeenCorner> nearestSeen(const StereoField& field, const Pose2& robot)
{
  const auto all = allSeen(field, robot);
  const auto nearest = std::min_element(all.begin(), all.end(),
                                        [](const SeenCorner& a, const SeenCorner& b) { return a.range < b.range; });
  if (nearest == all.end()) return std::nullopt;
  return *nearest;
}

Pose2 randomPose(const StereoField& field, RandomStream& random)
{
  const double x = random.uniform(field.margin, field.size.x() - field.margin);
  const double y = random.uniform(field.margin, field.size.y() - field.margin);
  return {x, y, random.uniform(-kPi, kPi)};
}

std::optional<StereoRange> wholePixelRange(const StereoField& field, double width, const SeenCorner& corner)
{
  return scaled(field, stereoRange(field.rig(width), std::round(disparity(field, width, corner)), kRounding,
                                   std::round(column(field, width, corner)), kRounding));
}

std::optional<StereoRange> subPixelRange(const StereoField& field, double width, const SeenCorner& corner,
                                         RandomStream& random)
{
  const double std = field.std_subpixel;
  const double noisy_disparity = disparity(field, width, corner) + std * random.gaussian();
  const double noisy_column = column(field, width, corner) + std * random.gaussian();
  return scaled(field, stereoRange(field.rig(width), noisy_disparity, std, noisy_column, std));
}

double rangeBound(const StereoField& field, double width, double std_disparity, const SeenCorner& corner)
{
  const StereoRange exact = stereoRange(field.rig(width), disparity(field, width, corner), std_disparity,
                                        column(field, width, corner), std_disparity);
  return std::sqrt(exact.covariance(0, 0));
}
}  // namespace mrpt_ext::papers
