#include "mrpt_ext/simulation/odometry_simulator.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/simulation/rounding.h"

namespace mrpt_ext
{
namespace
{
constexpr double kDriving = 0.01;  // [m/s] above which a turn is an arc
}  // namespace

SimulatedOdometry::SimulatedOdometry(const RobotPath& path, const OdometryNoise& noise, double duration,
                                     RandomStream& random)
    : path_(path), noise_(noise)
{
  if (!(noise.rate_hz > 0)) return;
  Pose2 reckoned;
  records_.push_back({0, reckoned});
  for (int tick = 1; records_.back().time < duration; ++tick)
  {
    const double begin = (tick - 1) / noise.rate_hz, end = tick / noise.rate_hz;
    const Pose2 moved = between(path.poseAt(begin), path.poseAt(end));
    const Vector3d std = incrementStd(begin, end);
    const double scale = 1 + noise.scale_error;
    const double dx = scale * moved.x + std.x() * random.gaussian();
    const double dy = scale * moved.y + std.y() * random.gaussian();
    const double length = path.lengthAt(end) - path.lengthAt(begin);
    const double dphi = rotationScale(begin, end) * (moved.phi - noise.veer * length) + std.z() * random.gaussian();
    const Vector3d unnoticed = slip(end - begin, random);
    reckoned =
        compose(reckoned, {dx + unnoticed.x(), dy + unnoticed.y(), dphi + noise.drift * (end - begin) + unnoticed.z()});
    records_.push_back({rounded(end), rounded(reckoned)});
  }
}

double SimulatedOdometry::rotationScale(double begin, double end) const
{
  const bool drives = path_.lengthAt(end) - path_.lengthAt(begin) > kDriving * (end - begin);
  return 1 + noise_.rotation_scale_error + (drives ? noise_.arc_scale_error : 0);
}

Vector3d SimulatedOdometry::slip(double duration, RandomStream& random) const
{
  if (!(noise_.slips_per_minute > 0) || !random.chance(noise_.slips_per_minute * duration / 60))
    return Vector3d::Zero();
  return {noise_.std_slip * random.gaussian(), noise_.std_slip * random.gaussian(),
          noise_.std_slip_heading * random.gaussian()};
}

Vector3d SimulatedOdometry::incrementStd(double begin, double end) const
{
  const double length = path_.lengthAt(end) - path_.lengthAt(begin);
  const double turned_deg = radToDeg(path_.turnedAt(end) - path_.turnedAt(begin));
  const double time = end - begin;
  const double xy = std::sqrt(square(noise_.std_xy_per_m) * length + square(noise_.std_xy_per_sqrt_s) * time);
  const double phi_deg =
      std::sqrt(square(noise_.std_phi_deg_per_deg) * turned_deg + square(noise_.std_phi_deg_per_m) * length +
                square(noise_.std_phi_deg_per_sqrt_s) * time);
  return {xy, xy, degToRad(phi_deg)};
}

std::optional<GaussianPose> SimulatedOdometry::displacement(double begin, double end) const
{
  const double gap = noise_.rate_hz > 0 ? 2 / noise_.rate_hz : 0;
  const auto first = interpolate(records_, begin, gap), last = interpolate(records_, end, gap);
  if (!first || !last) return std::nullopt;
  GaussianPose sum;
  for (double t = begin; t < end; t += 1 / noise_.rate_hz)
  {
    const double next = std::min(end, t + 1 / noise_.rate_hz);
    const auto a = interpolate(records_, t, gap), b = interpolate(records_, next, gap);
    const Matrix3d noise = incrementStd(t, next).cwiseAbs2().asDiagonal();
    sum = compound(sum, between(a->pose, b->pose), noise);
  }
  sum.mean = between(first->pose, last->pose);
  return sum;
}
}  // namespace mrpt_ext
