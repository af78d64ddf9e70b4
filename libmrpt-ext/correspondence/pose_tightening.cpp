#include "mrpt_ext/correspondence/pose_tightening.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr int kRounds = 3;
constexpr int kMostOfOneLandmark = 4;  // readings within the gates of one landmark, unless it is close

/// The landmark that explains a reading best, and how many could.
struct Explanation
{
  int candidates = 0;
  float distance2 = 0;  // in standard deviations of the innovation
  float misfit = 0;     // predicted minus measured [rad]
  std::size_t landmark = 0;
};

using Explanations = std::array<Explanation, ReadingTable::kMaxReadings>;

/// Angle of (x, y) against a unit vector, to better than 1e-5 of itself where it matters.
float angleAgainst(const Vector2d& unit, float x, float y)
{
  const auto u = static_cast<float>(unit.x()), v = static_cast<float>(unit.y());
  const float cross = u * y - v * x, dot = u * x + v * y;
  if (std::abs(cross) > 0.5F * dot) return std::atan2(cross, dot);
  const float t = cross / dot, t2 = t * t;
  return t * (1 - t2 * (1.0F / 3 - t2 * (1.0F / 5 - t2 * (1.0F / 7 - t2 / 9))));
}

/// Which landmark explains each reading; the number that are explained. A landmark so close that it could be in any
/// direction explains one reading, no matter which.
int explain(const SeenLandmarks& seen, const ReadingTable& table, float gate2, Explanations& found)
{
  int close = 0;
  for (std::size_t l = 0; l < seen.count; ++l)
  {
    if (std::popcount(seen.explains[l]) > kMostOfOneLandmark)
    {
      ++close;
      continue;
    }
    for (std::uint32_t set = seen.explains[l]; set != 0; set &= set - 1)
    {
      const int bit = std::countr_zero(set);
      const BearingReading& reading = table.reading(bit);
      const float misfit = angleAgainst(reading.direction, seen.x[l], seen.y[l]);
      const float distance2 = misfit * misfit / (static_cast<float>(square(reading.std)) + seen.variance[l]);
      if (distance2 > gate2) continue;
      Explanation& e = found[static_cast<std::size_t>(bit)];
      if (e.candidates++ > 0 && e.distance2 <= distance2) continue;
      e.distance2 = distance2;
      e.misfit = misfit;
      e.landmark = l;
    }
  }
  const auto explained =
      std::count_if(found.begin(), found.end(), [](const Explanation& e) { return e.candidates > 0; });
  return std::min(table.size(), static_cast<int>(explained) + close);
}
}  // namespace

TightenedPose tightenPose(const GaussianPose& sensor, std::span<const SieveView> views, double gate, int least,
                          SeenLandmarks& scratch)
{
  TightenedPose result{sensor};
  for (int round = 0;; ++round)
  {
    Matrix3d information = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    result.explained = 0;
    for (const SieveView& view : views)
    {
      lookAround(result.sensor, view, gate, scratch);
      Explanations found{};
      result.explained += explain(scratch, *view.table, static_cast<float>(gate * gate), found);
      for (int bit = 0; bit < view.table->size(); ++bit)
      {
        const Explanation& e = found[static_cast<std::size_t>(bit)];
        const bool own = (view.used >> bit & 1U) != 0;
        if (e.candidates == 0 || (round == 0 && e.candidates > 1 && !own)) continue;
        const Vector3d row(scratch.ex[e.landmark], scratch.ey[e.landmark], -scratch.w[e.landmark]);
        const double weight = 1 / square(view.table->reading(bit).std);
        information += weight * row * row.transpose();
        gradient += weight * e.misfit * row;
      }
    }
    if (result.explained < least || round == kRounds) return result;
    const Eigen::LDLT<Matrix3d> factors(information);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0)) return result;
    const Vector3d step = factors.solve(gradient);
    Pose2& pose = result.sensor.mean;
    pose = {pose.x - step.x(), pose.y - step.y(), wrap(pose.phi - step.z())};
    result.sensor.covariance = factors.solve(Matrix3d::Identity());
    result.refined = true;
  }
}
}  // namespace mrpt_ext
