#include "mrpt_ext/correspondence/points/false_alarms_points.h"

#include "mrpt_ext/correspondence/binomial.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPoseShare = 0.75;  // of a point's mean variance: what the pose's error adds to that of a prediction
}

PointFalseAlarmModel pointFalseAlarmModel(const LandmarkIndex& map, std::span<const ScanPoint> points, double gate)
{
  if (points.size() < 2 || map.empty()) return {0, 0, static_cast<int>(points.size())};
  const Vector2d extent = map.high() - map.low();
  const double area = std::max(extent.prod(), 0.01 * extent.squaredNorm() + 1e-9);
  const bool categories =
      std::none_of(points.begin(), points.end(), [](const auto& p) { return p.category == kAnyCategory; });
  const auto count = static_cast<double>(map.size());
  const double density = count / area / (categories ? std::max(1, map.categoriesPresent()) : 1);

  const auto n = static_cast<double>(points.size());
  double variance = 0, area_of_gate = 0, separation = 0;
  for (const ScanPoint& a : points)
  {
    const double worst = square(a.std), best = square(a.spread / a.std), mean = (worst + best) / 2;
    variance += mean / n;
    area_of_gate += 4 * square(gate) * std::sqrt((worst + kPoseShare * mean) * (best + kPoseShare * mean)) / n;
    for (const ScanPoint& b : points) separation += (a.in_robot - b.in_robot).norm() / (n * (n - 1));
  }
  const double tolerance = gate * std::sqrt(2 * variance);
  const double pairs = std::min(4 * kPi * density * area * density * separation * tolerance, count * (count - 1));
  return {pairs, -std::expm1(-area_of_gate * density), static_cast<int>(points.size())};
}

double expectedFalsePoses(const PointFalseAlarmModel& chance, int matched)
{
  const int m = std::max(matched, 2), n = chance.points;
  if (n < m) return 0;
  return chance.poses_per_pair * std::exp(logChoose(n, 2) - logChoose(m, 2)) *
         binomialTail(n - 2, m - 2, chance.chance);
}
}  // namespace mrpt_ext
