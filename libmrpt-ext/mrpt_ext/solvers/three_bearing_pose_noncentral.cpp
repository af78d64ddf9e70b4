#include "mrpt_ext/solvers/three_bearing_pose_noncentral.h"

#include <algorithm>

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSingular = 1e-10;  // relative, below this rounding decides

bool isUsableLine(const NoncentralBearing& line)
{
  return line.landmark.allFinite() && line.origin.allFinite() && line.direction.allFinite() &&
         std::abs(line.direction.squaredNorm() - 1) < 1e-6;
}

struct Lines
{
  std::array<NoncentralBearing, 3> line;  // landmarks relative to their mean, so that large coordinates cost no digits
  Vector2d mean;
  Vector3d w;  // sum w_i d_i = 0

  explicit Lines(const std::array<NoncentralBearing, 3>& lines) : line(lines)
  {
    mean = (lines[0].landmark + lines[1].landmark + lines[2].landmark) / 3;
    for (NoncentralBearing& l : line) l.landmark -= mean;
    w = {cross(line[1].direction, line[2].direction), cross(line[2].direction, line[0].direction),
         cross(line[0].direction, line[1].direction)};
  }

  /// Right-hand side of n_i . q for this heading, n_i = d_i turned by 90 degrees: how far along n_i the landmark is.
  [[nodiscard]] double offset(std::size_t i, double heading) const
  {
    return cross(line[i].direction, rotation(-heading) * line[i].landmark - line[i].origin);
  }

  [[nodiscard]] Pose2 poseFor(double heading) const
  {
    // The two lines that cut best: q from n_j . q and n_k . q.
    Eigen::Index best = 0;
    w.cwiseAbs().maxCoeff(&best);
    const auto j = static_cast<std::size_t>((best + 1) % 3), k = static_cast<std::size_t>((best + 2) % 3);
    const double sine = w[best];  // cross(d_j, d_k)
    const Vector2d q = (offset(j, heading) * line[k].direction - offset(k, heading) * line[j].direction) / sine;
    const Vector2d t = mean + rotation(heading) * q;
    return {t.x(), t.y(), wrap(heading)};
  }

  [[nodiscard]] bool ahead(const Pose2& pose) const
  {
    return std::all_of(line.begin(), line.end(),
                       [&](const NoncentralBearing& l)
                       {
                         const Vector2d v = rotation(-pose.phi) * (l.landmark + mean - pose.position());
                         return l.direction.dot(v - l.origin) > 0;
                       });
  }
};
}  // namespace

NoncentralThreeBearingPose solveNoncentralThreeBearingPose(const std::array<NoncentralBearing, 3>& lines)
{
  NoncentralThreeBearingPose result;
  if (!std::all_of(lines.begin(), lines.end(), isUsableLine)) return result;
  result.status = SolveStatus::degenerate;
  const Lines set(lines);
  double A = 0, B = 0, E = 0, lever = 0, reach = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const NoncentralBearing& l = set.line[i];
    const double w = set.w[static_cast<Eigen::Index>(i)];
    A += w * cross(l.direction, l.landmark);
    B += w * l.direction.dot(l.landmark);
    E += w * cross(l.direction, l.origin);
    lever += std::abs(w) * l.landmark.norm();
    reach = std::max(reach, l.landmark.norm());
  }
  const double H = std::hypot(A, B);
  if (set.w.cwiseAbs().maxCoeff() < kSingular || !(H > kSingular * lever)) return result;
  result.quality = H / (3 * reach);  // |w_i| <= 1
  if (std::abs(E) > H * (1 + kSingular))
  {
    result.status = SolveStatus::none;
    return result;
  }
  result.status = SolveStatus::behind;
  const double turn = std::acos(std::clamp(E / H, -1.0, 1.0)), middle = -std::atan2(B, A);
  for (const double heading : {middle + turn, middle - turn})
  {
    const Pose2 pose = set.poseFor(heading);
    if (!set.ahead(pose) || !isFinite(pose)) continue;
    if (result.count == 1 && std::abs(wrap(pose.phi - result.poses[0].phi)) < kSingular) continue;  // they touch
    result.poses[static_cast<std::size_t>(result.count++)] = pose;
  }
  if (result.count > 0) result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
