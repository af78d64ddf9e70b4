#include "mrpt_ext/correspondence/pose_tightening.h"

#include <Eigen/Cholesky>
#include <array>
#include <bit>
#include <cmath>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
namespace
{
constexpr int kRounds = 3;
constexpr double kUnlimited = 1e8;  // [m]

/// The landmark that explains a reading best, and how many could.
struct Explanation
{
  int candidates = 0;
  double distance2 = 0;  // in standard deviations of the innovation
  double misfit = 0;     // predicted minus measured [rad]
  double weight = 0;     // 1 / variance of the reading
  Vector3d row{0, 0, 0};
};

using Explanations = std::array<Explanation, ReadingTable::kMaxReadings>;

double misfitOf(const Vector2d& direction, const Vector2d& measured)
{
  const double cross = measured.x() * direction.y() - measured.y() * direction.x(), dot = measured.dot(direction);
  if (std::abs(cross) > 0.5 * dot) return std::atan2(cross, dot);
  const double t = cross / dot, t2 = t * t;
  return t * (1 - t2 * (1.0 / 3 - t2 * (1.0 / 5 - t2 * (1.0 / 7 - t2 / 9))));
}

/// What a place sees of the landmarks from the pose.
int explain(const GaussianPose& tested, const SieveView& view, double gate, Explanations& found)
{
  const Pose2 sensor = compose(tested.mean, view.T_tested_sensor);
  const Vector2d offset = sensor.position() - tested.mean.position();
  const auto at = view.lists->cellAt(sensor.position());
  const VisibleLists::Cell& cell = at.cell;
  const Vector2d origin = sensor.position() - at.centre;
  const double c = std::cos(sensor.phi), s = std::sin(sensor.phi);
  const Matrix3d& P = tested.covariance;
  const double reach = std::min(view.lists->maxRange(), kUnlimited) + gate * std::sqrt(P(0, 0) + P(1, 1));
  for (std::size_t l = 0; l < cell.count; ++l)
  {
    const Vector2d d = Vector2d(cell.x[l], cell.y[l]) - origin;
    const double r2 = std::max(d.squaredNorm(), 1e-6);
    if (r2 > reach * reach) continue;
    const Vector3d row(d.y() / r2, -d.x() / r2, -1 - offset.dot(d) / r2);
    const double variance = std::max(0.0, row.dot(P * row));
    const Vector2d seen(c * d.x() + s * d.y(), c * d.y() - s * d.x());
    const auto ratio = static_cast<float>(1 + variance * view.table->inverseVariance());
    std::uint32_t set =
        view.table->explainedBy(static_cast<float>(seen.x()), static_cast<float>(seen.y()), ratio, cell.kind[l]);
    for (; set != 0; set &= set - 1)
    {
      const int bit = std::countr_zero(set);
      const BearingReading& reading = view.table->reading(bit);
      const double misfit = misfitOf(seen, reading.direction);
      const double distance2 = square(misfit) / (square(reading.std) + variance);
      if (distance2 > square(gate)) continue;
      Explanation& e = found[static_cast<std::size_t>(bit)];
      if (e.candidates++ > 0 && e.distance2 <= distance2) continue;
      e.distance2 = distance2;
      e.misfit = misfit;
      e.weight = 1 / square(reading.std);
      e.row = row;
    }
  }
  int explained = 0;
  for (const Explanation& e : found) explained += e.candidates > 0;
  return explained;
}
}  // namespace

TightenedPose tightenPose(const GaussianPose& sensor, std::span<const SieveView> views, double gate, int least)
{
  TightenedPose result{sensor, 0};
  for (int round = 0;; ++round)
  {
    Matrix3d information = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    result.explained = 0;
    for (const SieveView& view : views)
    {
      Explanations found{};
      result.explained += explain(result.sensor, view, gate, found);
      for (std::size_t bit = 0; bit < found.size(); ++bit)
      {
        const Explanation& e = found[bit];
        const bool own = (view.used >> bit & 1U) != 0;
        if (e.candidates == 0 || (round == 0 && e.candidates > 1 && !own)) continue;
        information += e.weight * e.row * e.row.transpose();
        gradient += e.weight * e.misfit * e.row;
      }
    }
    if (result.explained < least || round == kRounds) return result;
    const Eigen::LDLT<Matrix3d> factors(information);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0)) return result;
    const Vector3d step = factors.solve(gradient);
    Pose2& pose = result.sensor.mean;
    pose = {pose.x - step.x(), pose.y - step.y(), wrap(pose.phi - step.z())};
    result.sensor.covariance = factors.solve(Matrix3d::Identity());
  }
}
}  // namespace mrpt_ext
