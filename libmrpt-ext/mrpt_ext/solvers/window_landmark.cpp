#include "mrpt_ext/solvers/window_landmark.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "mrpt_ext/solvers/omni_stereo.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/two_circles.h"
#include "mrpt_ext/solvers/window_noise.h"

namespace mrpt_ext
{
namespace
{
constexpr double kAlsoPossible = 9;  // chi2 above the best
constexpr double kVague = 0.5;       // relative standard deviation of the distance from which on there is no point
constexpr double kSameSpread = 1;    // squared Mahalanobis distance of minima that are one
constexpr std::size_t kMaxSeedPairs = 3;

using Observations = std::span<const WindowObservation>;

double worldAngle(const WindowObservation& s) { return *s.bearing + s.T_robot_sensor.phi; }
SightRay rayOf(const WindowObservation& s) { return {s.T_robot_sensor.position(), worldAngle(s), s.std_bearing}; }

bool isUsableObservation(const WindowObservation& s)
{
  const bool bearing = !s.bearing || (std::isfinite(*s.bearing) && s.std_bearing > 0 && std::isfinite(s.std_bearing));
  const bool range =
      !s.range || (*s.range >= 0 && std::isfinite(*s.range) && s.std_range > 0 && std::isfinite(s.std_range));
  return bearing && range && isFinite(s.T_robot_sensor) && s.odometry_covariance.allFinite();
}

/// Quadratic model of the joint cost for a landmark at `v` (robot frame).
NormalEquations<2> modelAt(Observations observations, const Vector2d& v)
{
  NormalEquations<2> information;
  // An error of the robot's pose moves the landmark in the robot frame, by (dx, dy) + dphi * perp(v).
  Eigen::Matrix<double, 2, 3> swing;
  swing << Matrix2d::Identity(), perpendicular(v);
  for (std::size_t k = 0; k < observations.size(); ++k)
  {
    const WindowObservation& s = observations[k];
    const Vector2d d = v - s.T_robot_sensor.position();
    const double r2 = std::max(d.squaredNorm(), 1e-12), r = std::sqrt(r2);
    if (s.bearing)
      addReading(information, wrap(angleOf(d) - worldAngle(s)), (perpendicular(d) / r2).transpose(), s.std_bearing);
    if (s.range) addReading(information, r - *s.range, (d / r).transpose(), s.std_range);
    Matrix3d noise = s.odometry_covariance;
    if (k + 1 < observations.size()) noise -= observations[k + 1].odometry_covariance;
    diffuse<2>(information, swing * noise * swing.transpose());
  }
  return information;
}

/// Pairs of observations that satisfy `first` and `second`, those with the longest baseline first.
template <typename First, typename Second>
std::vector<std::pair<const WindowObservation*, const WindowObservation*>> widestPairs(Observations observations,
                                                                                       First&& first, Second&& second)
{
  std::vector<std::pair<const WindowObservation*, const WindowObservation*>> pairs;
  for (const WindowObservation& a : observations)
    for (const WindowObservation& b : observations)
      if (&a != &b && first(a) && second(b)) pairs.emplace_back(&a, &b);
  const auto width = [](const auto& pair)
  { return (pair.first->T_robot_sensor.position() - pair.second->T_robot_sensor.position()).squaredNorm(); };
  const std::size_t kept = std::min(kMaxSeedPairs, pairs.size());
  std::partial_sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(kept), pairs.end(),
                    [&](const auto& a, const auto& b) { return width(a) > width(b); });
  pairs.resize(kept);
  return pairs;
}

/// Intersections of a ray with a circle, 0 to 2 points ahead; a ray that misses it gives its nearest point.
void addRayCircle(const WindowObservation& ray, const WindowObservation& circle, std::vector<Vector2d>& seeds)
{
  const Vector2d d = direction(worldAngle(ray)), to = circle.T_robot_sensor.position() - ray.T_robot_sensor.position();
  const double along = d.dot(to), half2 = square(*circle.range) - square(cross(d, to));
  const double half = std::sqrt(std::max(0.0, half2));
  for (const double s : {along - half, along + half})
    if (s > 0) seeds.emplace_back(ray.T_robot_sensor.position() + s * d);
}

void addTwoCircles(const WindowObservation& a, const WindowObservation& b, std::vector<Vector2d>& seeds)
{
  const Vector2d from = a.T_robot_sensor.position(), to = b.T_robot_sensor.position();
  const TwoCircles circles = intersectCircles({from, *a.range}, {to, *b.range});
  for (int k = 0; k < circles.count; ++k) seeds.push_back(circles.points[static_cast<std::size_t>(k)]);
  if (circles.count > 0 || !(circles.gap > 0)) return;
  // The circles miss by noise: seeds on both sides of the line of centres, on which the descent would stay.
  const Vector2d aside =
      perpendicular((to - from).normalized()) * std::sqrt(circles.gap * std::max(*a.range, *b.range));
  seeds.emplace_back(circles.closest + aside);
  seeds.emplace_back(circles.closest - aside);
}

std::vector<Vector2d> seedsFor(Observations observations)
{
  const auto has_bearing = [](const WindowObservation& s) { return s.bearing.has_value(); };
  const auto has_range = [](const WindowObservation& s) { return s.range.has_value(); };
  std::vector<Vector2d> seeds;
  for (const WindowObservation& s : observations)
    if (s.bearing && s.range) seeds.emplace_back(transform(s.T_robot_sensor, *s.range * direction(*s.bearing)));
  if (!seeds.empty()) return {seeds.front(), seeds.back()};
  for (const auto& [a, b] : widestPairs(observations, has_bearing, has_bearing))
    if (const Triangulation t = triangulate(rayOf(*a), rayOf(*b)); t.status == SolveStatus::ok)
      seeds.push_back(t.point.mean);
  for (const auto& [a, b] : widestPairs(observations, has_bearing, has_range)) addRayCircle(*a, *b, seeds);
  for (const auto& [a, b] : widestPairs(observations, has_range, has_range)) addTwoCircles(*a, *b, seeds);
  return seeds;
}

/// Distance to the nearest sensor position from which the landmark was observed.
double distanceTo(Observations observations, const Vector2d& v)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const WindowObservation& s : observations) nearest = std::min(nearest, (v - s.T_robot_sensor.position()).norm());
  return nearest;
}

/// Standard deviation along the weak direction for ranges along a line: how far the landmark can move while the
/// circles, which differ only by their curvature, stay within their noise. Infinite if there are bearings, whose model
/// is linear.
double curvatureSpread(Observations observations, const Vector2d& v)
{
  double least = std::numeric_limits<double>::infinity(), most = 0, std = 0;
  for (const WindowObservation& s : observations)
  {
    if (s.bearing) return std::numeric_limits<double>::infinity();
    const Vector2d d = v - s.T_robot_sensor.position();
    // Signed: behind the landmark the circles bend the other way.
    const double towards = d.dot(v - observations.back().T_robot_sensor.position()) < 0 ? -1 : 1;
    const double curvature = towards / std::max(d.norm(), 1e-6);
    least = std::min(least, curvature);
    most = std::max(most, curvature);
    std = std::max(std, std::sqrt(square(s.std_range) + s.odometry_covariance.topLeftCorner<2, 2>().trace()));
  }
  return most > least ? std::sqrt(2 * std::sqrt(2.0) * std / (most - least)) : std::numeric_limits<double>::infinity();
}

/// Covariance at a minimum; none if the readings determine no point.
std::optional<Matrix2d> covarianceAt(Observations observations, const Vector2d& v, const Matrix2d& information)
{
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(information);
  const Vector2d& strength = eigen.eigenvalues();  // ascending
  if (!(strength.y() > 0) || !v.allFinite()) return std::nullopt;
  const double linear = strength.x() > 0 ? 1 / std::sqrt(strength.x()) : std::numeric_limits<double>::infinity();
  const double weak = std::min(linear, curvatureSpread(observations, v));
  if (!(weak < kVague * distanceTo(observations, v))) return std::nullopt;
  const Vector2d along = eigen.eigenvectors().col(0), across = eigen.eigenvectors().col(1);
  return Matrix2d(weak * weak * along * along.transpose() + 1 / strength.y() * across * across.transpose());
}
}  // namespace

WindowLandmark locateLandmark(std::span<const WindowObservation> oldest_first)
{
  WindowLandmark result;
  result.status = SolveStatus::bad_input;
  if (!std::all_of(oldest_first.begin(), oldest_first.end(), isUsableObservation)) return result;
  for (const WindowObservation& s : oldest_first) result.readings += (s.bearing ? 1 : 0) + (s.range ? 1 : 0);
  result.status = SolveStatus::too_few;
  if (result.readings < 2) return result;

  const std::vector<Vector2d> seeds = seedsFor(oldest_first);
  result.status = seeds.empty() ? SolveStatus::none : SolveStatus::degenerate;
  for (Vector2d v : seeds)
  {
    const auto model = [&](const Vector2d& p) { return modelAt(oldest_first, p); };
    descend<2>(
        v, model, [&](const Vector2d& p) { return model(p).cost; },
        [](const Vector2d& p, const Vector2d& step) { return Vector2d(p + step); }, {30, 1e-8});
    const NormalEquations<2> minimum = model(v);
    const std::optional<Matrix2d> covariance = covarianceAt(oldest_first, v, minimum.hessian);
    if (!covariance) continue;
    const bool known = std::any_of(result.candidates.begin(), result.candidates.end(),
                                   [&](const LocalizedLandmark& p)
                                   {
                                     const Vector2d e = p.in_robot.mean - v;
                                     return e.dot(minimum.hessian * e) < kSameSpread;
                                   });
    if (!known) result.candidates.push_back({{v, *covariance}, minimum.cost});
  }
  std::stable_sort(result.candidates.begin(), result.candidates.end(),
                   [](const auto& a, const auto& b) { return a.chi2 < b.chi2; });
  std::erase_if(result.candidates,
                [&](const auto& p) { return p.chi2 > result.candidates.front().chi2 + kAlsoPossible; });
  if (!result.candidates.empty()) result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
