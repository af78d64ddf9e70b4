#include "mrpt_ext/vision/axis_ellipse.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr int kIterations = 4;
constexpr double kSmallestReciprocalCondition = 1e-12;

/// Distance and its derivative by (centre u, centre v, semi_u, semi_v).
struct DistanceRow
{
  double distance = 0;
  Eigen::Vector4d gradient;
};

/// With q the scaled radius (1 on the ellipse) the distance is (q - 1) / |grad q|; the derivative leaves out that
/// |grad q| changes, which does not matter near the ellipse.
DistanceRow distanceRow(const AxisEllipse& e, const cv::Point2d& p)
{
  const double x = (p.x - e.centre.x) / e.semi_u, y = (p.y - e.centre.y) / e.semi_v;
  const double q = std::hypot(x, y);
  if (!(q > 0)) return {-std::min(e.semi_u, e.semi_v), Eigen::Vector4d::Zero()};
  const double gu = x / (q * e.semi_u), gv = y / (q * e.semi_v), norm = std::hypot(gu, gv);
  return {(q - 1) / norm, Eigen::Vector4d(-gu, -gv, -x * gu, -y * gv) / norm};
}

bool isEllipse(const AxisEllipse& e)
{
  return std::isfinite(e.centre.x) && std::isfinite(e.centre.y) && std::isfinite(e.semi_u) && std::isfinite(e.semi_v) &&
         e.semi_u > 0 && e.semi_v > 0;
}
}  // namespace

double AxisEllipse::distance(const cv::Point2d& p) const { return distanceRow(*this, p).distance; }

std::optional<AxisEllipse> ellipseThrough(const std::vector<cv::Point2d>& points)
{
  if (points.size() < 4) return std::nullopt;
  cv::Point2d mean;
  for (const cv::Point2d& p : points) mean += p;
  mean *= 1.0 / static_cast<double>(points.size());
  double scale = 0;
  for (const cv::Point2d& p : points) scale = std::max({scale, std::abs(p.x - mean.x), std::abs(p.y - mean.y)});
  if (!(scale > 0)) return std::nullopt;

  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const cv::Point2d& p : points)
  {
    const double u = (p.x - mean.x) / scale, v = (p.y - mean.y) / scale;
    const Eigen::Vector4d row(v * v, u, v, 1);
    normal += row * row.transpose();
    right -= row * u * u;
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> solver(normal);
  if (!(solver.rcond() > kSmallestReciprocalCondition)) return std::nullopt;
  const Eigen::Vector4d c = solver.solve(right);  // B, C, D, E
  const double u0 = -c[1] / 2, v0 = -c[2] / (2 * c[0]);
  const double square = u0 * u0 + c[0] * v0 * v0 - c[3];
  if (!(c[0] > 0) || !(square > 0)) return std::nullopt;
  AxisEllipse ellipse{
      {mean.x + scale * u0, mean.y + scale * v0}, scale * std::sqrt(square), scale * std::sqrt(square / c[0])};
  return isEllipse(ellipse) ? std::optional(ellipse) : std::nullopt;
}

std::optional<EllipseFit> refineEllipse(const AxisEllipse& start, const std::vector<cv::Point2d>& points)
{
  if (points.size() < 5 || !isEllipse(start)) return std::nullopt;
  EllipseFit fit{start};
  for (int iteration = 0; iteration <= kIterations; ++iteration)
  {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double squares = 0;
    for (const cv::Point2d& p : points)
    {
      const DistanceRow row = distanceRow(fit.ellipse, p);
      normal += row.gradient * row.gradient.transpose();
      right -= row.gradient * row.distance;
      squares += row.distance * row.distance;
    }
    const Eigen::FullPivLU<Eigen::Matrix4d> solver(normal);
    if (!(solver.rcond() > kSmallestReciprocalCondition)) return std::nullopt;
    const double count = static_cast<double>(points.size());
    fit.rms = std::sqrt(squares / count);
    fit.covariance = solver.inverse() * (squares / (count - 4));
    if (iteration == kIterations) break;  // the last round only judges
    const Eigen::Vector4d step = solver.solve(right);
    fit.ellipse.centre += cv::Point2d(step[0], step[1]);
    fit.ellipse.semi_u += step[2];
    fit.ellipse.semi_v += step[3];
    if (!isEllipse(fit.ellipse)) return std::nullopt;
  }
  return fit;
}
}  // namespace mrpt_ext
