#include "mrpt_ext/vision/mirror_alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kComparedParts = 3;  ///< of an edge, at least
constexpr double kComparedSpan = 0.25;     ///< of an edge, share of the rim's radius
constexpr std::size_t kComparedEdges = 8;
constexpr double kPartFloor = 0.0003;  ///< [rad] of a part, beyond noise
constexpr double kTukey = 4.7;         ///< standard deviations from which on a part does not count
constexpr double kStraight = 5;        ///< standard deviations from which on a part is not one of a straight edge
constexpr double kStraighter = 0.8;    ///< by less, edges are not worth new axes
constexpr double kMoreParts = 1.1;     ///< likewise
constexpr double kByChance = 1.7;      ///< of a single edge, share by which other axes may seem better
constexpr int kReweightings = 8;

/// A part's azimuth against the mean of its edge's parts.
struct PartRow
{
  double azimuth = 0;
  double std = 0;
  double weight = 1;  ///< of the reweighting
  Vector6 gradient;
};

using EdgeRows = std::vector<PartRow>;

EdgeRows rowsOf(const RadialEdge& edge, const MirrorAxis& axis)
{
  EdgeRows rows;
  for (const EdgePart& part : edge.parts)
  {
    const CentreShifts shifts = centreShifts(axis.cone_half_angle, axis.rim_angle, part.radius);
    const Eigen::Vector2d tangent = Eigen::Vector2d(-std::sin(part.azimuth), std::cos(part.azimuth)) / part.radius;
    PartRow row{wrap(part.azimuth - edge.azimuth), std::hypot(part.std_azimuth, kPartFloor), 1, {}};
    row.gradient << shifts.by_offset * tangent, shifts.by_camera_tilt * tangent, shifts.by_vertical_tilt * tangent;
    rows.push_back(row);
  }
  return rows;
}

/// Azimuth and gradient of a part against the weighted means of its edge.
struct CentredRow
{
  double residual = 0;
  Vector6 gradient;
};

std::vector<CentredRow> centred(const EdgeRows& rows)
{
  double total = 0, azimuth = 0;
  Vector6 gradient = Vector6::Zero();
  for (const PartRow& row : rows)
  {
    const double weight = row.weight / square(row.std);
    total += weight;
    azimuth += weight * row.azimuth;
    gradient += weight * row.gradient;
  }
  std::vector<CentredRow> result;
  for (const PartRow& row : rows)
    result.push_back({row.azimuth - (total > 0 ? azimuth / total : 0),
                      row.gradient - (total > 0 ? Vector6(gradient / total) : Vector6::Zero())});
  return result;
}

/// The sum of squares of a sequence and what is known beforehand.
class AlignmentProblem
{
 public:
  AlignmentProblem(const std::vector<AlignmentView>& views, const MirrorAxis& start, const AlignmentPriors& priors)
  {
    for (const AlignmentView& view : views)
      for (const RadialEdge& edge : view.edges)
        if (edge.parts.size() >= kComparedParts &&
            edge.parts.back().radius - edge.parts.front().radius >= kComparedSpan)
          edges_.push_back(rowsOf(edge, start));
    const AxisEllipse& rim = views.front().rim;
    const cv::Point2d offset = mirrorOffset(rim, start);
    start_ << offset.x / rim.semi_u, offset.y / rim.semi_v, start.camera_tilt.x, start.camera_tilt.y,
        start.vertical_tilt.x, start.vertical_tilt.y;
    Vector6 information;
    information << 1, 1, 0, 0, 0, 0;
    information /= square(priors.offset);
    information.segment<2>(2).setConstant(1 / square(priors.camera_tilt));
    information.tail<2>().setConstant(1 / square(priors.vertical_tilt));
    prior_ = information.asDiagonal();
    right_ = -prior_ * start_;
    if (priors.principal_point > 0)
    {  // What the offset grows by, the tilt must take back, or the stated principal point moves.
      const double slope = std::tan(start.rim_angle);
      Eigen::Matrix<double, 2, 6> row = Eigen::Matrix<double, 2, 6>::Zero();
      row.leftCols<2>().setIdentity();
      row.middleCols<2>(2) = (1 / slope + slope) * Eigen::Matrix2d::Identity();
      prior_ += row.transpose() * row / square(priors.principal_point);
    }
  }

  [[nodiscard]] std::size_t edges() const { return edges_.size(); }
  [[nodiscard]] const Vector6& start() const { return start_; }
  [[nodiscard]] const Matrix6& covariance() const { return covariance_; }

  /// Change of the six parameters.
  [[nodiscard]] Vector6 solve()
  {
    Vector6 change = Vector6::Zero();
    for (int round = 0; round < kReweightings; ++round)
    {
      Matrix6 normal = prior_;
      Vector6 right = right_;
      const double variance = square(scaleAt(change));
      reweight(change, std::sqrt(variance));
      for (const EdgeRows& edge : edges_)
      {
        const auto rows = centred(edge);
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
          const double weight = edge[i].weight / (square(edge[i].std) * variance);
          normal += weight * rows[i].gradient * rows[i].gradient.transpose();
          right += weight * rows[i].residual * rows[i].gradient;
        }
      }
      covariance_ = normal.inverse();
      change = covariance_ * right;
    }
    return change;
  }

  /// Robust standard deviation of the residuals in units of the stated ones.
  [[nodiscard]] double scaleAt(const Vector6& change) const
  {
    const auto sizes = residualsAt(change, true);
    return sizes.empty() ? 1 : std::max(0.1, upperMedian(sizes) / kNormalMedianDeviation);
  }
  [[nodiscard]] double straightPartsAt(const Vector6& change) const
  {
    double count = 0;
    for (const double size : residualsAt(change, true)) count += std::max(0.0, 1 - square(size / kStraight));
    return count;
  }
  [[nodiscard]] double bendAt(const Vector6& change) const { return upperMedian(residualsAt(change, false)); }

 private:
  [[nodiscard]] std::vector<double> residualsAt(const Vector6& change, bool normalized) const
  {
    std::vector<double> sizes;
    for (const EdgeRows& edge : edges_)
    {
      const auto rows = centred(edge);
      for (std::size_t i = 0; i < rows.size(); ++i)
        sizes.push_back(std::abs(rows[i].residual - rows[i].gradient.dot(change)) / (normalized ? edge[i].std : 1));
    }
    return sizes;
  }
  void reweight(const Vector6& change, double scale)
  {
    for (EdgeRows& edge : edges_)
    {
      const auto rows = centred(edge);
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const double share = square((rows[i].residual - rows[i].gradient.dot(change)) / (scale * edge[i].std * kTukey));
        edge[i].weight = share < 1 ? square(1 - share) : 0;
      }
    }
  }

  std::vector<EdgeRows> edges_;
  Vector6 start_, right_;
  Matrix6 prior_, covariance_ = Matrix6::Zero();
};

MirrorAxis changed(const MirrorAxis& start, const AxisEllipse& rim, const Vector6& parameters)
{
  MirrorAxis axis = start;
  axis.camera_tilt = {parameters[2], parameters[3]};
  axis.vertical_tilt = {parameters[4], parameters[5]};
  // The principal point is where it has to be for this offset of the mirror.
  axis.principal_point += mirrorOffset(rim, axis) - cv::Point2d(parameters[0] * rim.semi_u, parameters[1] * rim.semi_v);
  return axis;
}
}  // namespace

bool MirrorAlignment::isBetter() const
{
  const double chance = kByChance / std::sqrt(static_cast<double>(std::max<std::size_t>(1, edges)));
  return bend_after < std::min(kStraighter, 1 - chance) * bend_before ||
         straight_parts > std::max(kMoreParts, 1 + chance) * straight_before;
}

double MirrorAlignment::stdAzimuth(double share) const
{
  const CentreShifts shifts = centreShifts(axis.cone_half_angle, axis.rim_angle, share);
  Eigen::Matrix<double, 2, 6> by_parameters = Eigen::Matrix<double, 2, 6>::Zero();
  by_parameters.leftCols<2>() = shifts.by_offset / share * Eigen::Matrix2d::Identity();
  by_parameters.middleCols<2>(2) = shifts.by_camera_tilt / share * Eigen::Matrix2d::Identity();
  by_parameters.rightCols<2>() = shifts.by_vertical_tilt / share * Eigen::Matrix2d::Identity();
  return std::sqrt((by_parameters * covariance * by_parameters.transpose()).trace() / 2 + square(std_usual));
}

std::optional<MirrorAlignment> alignMirror(const std::vector<AlignmentView>& views, const MirrorAxis& start,
                                           const AlignmentPriors& priors)
{
  if (views.empty()) return std::nullopt;
  AlignmentProblem problem(views, start, priors);
  if (problem.edges() < kComparedEdges) return std::nullopt;
  const Vector6 change = problem.solve();
  MirrorAlignment alignment;
  alignment.axis = changed(start, views.front().rim, problem.start() + change);
  alignment.offset = (problem.start() + change).head<2>();
  alignment.covariance = problem.covariance();
  alignment.edges = problem.edges();
  alignment.bend_before = problem.bendAt(Vector6::Zero());
  alignment.bend_after = problem.bendAt(change);
  alignment.straight_before = problem.straightPartsAt(Vector6::Zero());
  alignment.straight_parts = problem.straightPartsAt(change);
  return alignment;
}
}  // namespace mrpt_ext
