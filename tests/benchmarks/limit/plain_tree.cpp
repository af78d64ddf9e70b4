#include "limit/plain_tree.h"

#include <cmath>

namespace mrpt_ext
{
PlainTree::PlainTree(std::vector<Point> landmarks, const std::vector<double>& bearings, double gate)
    : landmarks_(std::move(landmarks)),
      tangent2_(std::tan(gate) * std::tan(gate)),
      path_(bearings.size()),
      used_(landmarks_.size(), 0)
{
  for (const double b : bearings) units_.push_back({std::cos(b), std::sin(b)});
}

int PlainTree::search()
{
  solutions_ = 0;
  found_in_order_ = false;
  extend(0, {});
  return solutions_;
}

void PlainTree::extend(std::size_t depth, const Pose& prefix)
{
  if (depth == units_.size())
  {
    ++solutions_;
    bool in_order = true;
    for (std::size_t i = 0; i < path_.size(); ++i) in_order = in_order && path_[i] == i;
    found_in_order_ = found_in_order_ || in_order;
    return;
  }
  const Point& unit = units_[depth];
  const double ray_x = prefix.c * unit.x - prefix.s * unit.y, ray_y = prefix.s * unit.x + prefix.c * unit.y;
  for (std::size_t l = 0; l < landmarks_.size(); ++l)
  {
    if (used_[l]) continue;
    if (depth >= 3)
    {
      const double dx = landmarks_[l].x - prefix.x, dy = landmarks_[l].y - prefix.y;
      const double across = ray_x * dy - ray_y * dx, along = ray_x * dx + ray_y * dy;
      if (along <= 0 || across * across > tangent2_ * along * along) continue;
    }
    path_[depth] = l;
    Pose pose = prefix;
    if (depth >= 2 && !solve(depth + 1, pose)) continue;
    used_[l] = 1;
    extend(depth + 1, pose);
    used_[l] = 0;
  }
}

/// Paper 000, eq 3-6: f = -(sum n n^T)^-1 sum n (n . b'), R = L_0 - 1/f, with n the normal of (L_i - L_0) turned by
/// the bearing; every landmark must lie before the robot.
bool PlainTree::solve(std::size_t matched, Pose& pose) const
{
  const Point &origin = landmarks_[path_[0]], &first = units_[0];
  double sxx = 0, sxy = 0, syy = 0, vx = 0, vy = 0;
  for (std::size_t i = 1; i < matched; ++i)
  {
    const double dx = landmarks_[path_[i]].x - origin.x, dy = landmarks_[path_[i]].y - origin.y;
    const double inverse = 1 / (dx * dx + dy * dy);
    const double c = units_[i].x * first.x + units_[i].y * first.y, s = units_[i].y * first.x - units_[i].x * first.y;
    // (nx, ny) / |d| is the unit normal of exp(j (b_i - b_0)) / d; b' = conj(d) / |d|^2
    const double nx = c * dy - s * dx, ny = c * dx + s * dy;
    const double along = (nx * dx - ny * dy) * inverse * inverse;
    sxx += nx * nx * inverse;
    sxy += nx * ny * inverse;
    syy += ny * ny * inverse;
    vx += nx * along;
    vy += ny * along;
  }
  const double gx = sxy * vy - syy * vx, gy = sxy * vx - sxx * vy, g2 = gx * gx + gy * gy;  // f times det
  if (g2 < 1e-24) return false;
  const double scale = (sxx * syy - sxy * sxy) / g2;
  const double to_x = gx * scale, to_y = -gy * scale;  // L_0 - R
  const double c = to_x * first.x + to_y * first.y, s = to_y * first.x - to_x * first.y;
  const double length = std::sqrt(c * c + s * s);
  if (!(length > 0)) return false;
  pose = {origin.x - to_x, origin.y - to_y, c / length, s / length};
  for (std::size_t i = 1; i < matched; ++i)
  {
    const double dx = landmarks_[path_[i]].x - pose.x, dy = landmarks_[path_[i]].y - pose.y;
    const double ray_x = pose.c * units_[i].x - pose.s * units_[i].y,
                 ray_y = pose.s * units_[i].x + pose.c * units_[i].y;
    if (ray_x * dx + ray_y * dy <= 0) return false;
  }
  return true;
}
}  // namespace mrpt_ext
