#include "mrpt_ext/correspondence/bearings/inlier_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kRoundsOnAll = 2;
constexpr std::size_t kAny = DirectionTable::kMaxBearings;
/// Number of bearings with a single possible landmark that are added to those of the triple, round by round. While
/// the pose is uncertain that landmark may be a wrong one, so the best predicted bearings come first.
constexpr std::array<std::size_t, 2> kAddedToTriple{1, 3};
constexpr std::array<std::size_t, 1> kAddedToBox{kAny};  // the pose is only bounded, by no bearings of its own

// Operations: of a round, of a landmark whose gate is computed, of a bearing compared with a landmark in its gate, of a
// bearing in the system of equations.
constexpr std::uint64_t kOfRound = 250, kOfGate = 6, kOfResidual = 16, kOfRow = 12;

/// The landmark with the smallest residual for a bearing, and the number of possible ones.
struct Association
{
  int candidates = 0;
  float distance2 = 0;  // in standard deviations of the innovation
  float residual = 0;   // predicted minus measured [rad]
  std::size_t landmark = 0;
};

using Associations = std::array<Association, DirectionTable::kMaxBearings>;

/// Angle of (x, y) against a unit vector, to better than 1e-5 of itself where it matters.
float angleAgainst(const Vector2d& unit, float x, float y)
{
  const auto u = static_cast<float>(unit.x()), v = static_cast<float>(unit.y());
  const float cross = u * y - v * x, dot = u * x + v * y;
  if (std::abs(cross) > 0.5F * dot || dot == 0) return std::atan2(cross, dot);  // 0 at the landmark itself
  const float t = cross / dot, t2 = t * t;
  return t * (1 - t2 * (1.0F / 3 - t2 * (1.0F / 5 - t2 * (1.0F / 7 - t2 / 9))));
}

/// True for a set of more than `count` bits.
bool hasMoreThan(int count, std::uint32_t set)
{
  for (; set != 0 && count > 0; --count) set &= set - 1;
  return set != 0;
}

/// Best landmark of each bearing; returns the number of inliers. A landmark so close that it may be in any
/// direction matches one bearing, any one.
int associate(const GatedLandmarks& seen, const DirectionTable& table, float gate2, Associations& found,
              std::uint64_t& operations)
{
  operations += kOfGate * seen.count;
  int close = 0;
  for (std::size_t l = 0; l < seen.count; ++l)
  {
    if (seen.inliers[l] == 0) continue;
    if (hasMoreThan(kMostOfOneLandmark, seen.inliers[l]))
    {
      ++close;
      continue;
    }
    for (std::uint32_t set = seen.inliers[l]; set != 0; set &= set - 1)
    {
      const int bit = std::countr_zero(set);
      operations += kOfResidual;
      const ScanBearing& bearing = table.bearing(bit);
      const float residual = angleAgainst(bearing.direction, seen.x[l], seen.y[l]);
      const float distance2 = residual * residual / (static_cast<float>(square(bearing.std)) + seen.variance[l]);
      if (distance2 > gate2) continue;
      Association& e = found[static_cast<std::size_t>(bit)];
      if (e.candidates++ > 0 && e.distance2 <= distance2) continue;
      e.distance2 = distance2;
      e.residual = residual;
      e.landmark = l;
    }
  }
  const auto inliers = std::count_if(found.begin(), found.end(), [](const Association& e) { return e.candidates > 0; });
  return std::min(table.size(), static_cast<int>(inliers) + close);
}

/// Variance [rad^2] of the predicted bearing up to which bearings take part, so that `count` are added.
float largestVariance(const Associations& found, const BoundingScan& scan, const GatedLandmarks& seen,
                      std::size_t count)
{
  std::array<float, DirectionTable::kMaxBearings> variance{};
  std::size_t size = 0;
  for (int bit = 0; bit < scan.table->size(); ++bit)
  {
    const Association& e = found[static_cast<std::size_t>(bit)];
    if (e.candidates == 1 && (scan.used >> bit & 1U) == 0) variance[size++] = seen.variance[e.landmark];
  }
  if (size <= count) return std::numeric_limits<float>::infinity();
  const auto last = variance.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(variance.begin(), last, variance.begin() + static_cast<std::ptrdiff_t>(size));
  return *last;
}

/// Numbers of bearings to add in the first rounds.
std::span<const std::size_t> addedBy(std::span<const BoundingScan> scans)
{
  const bool of_triple =
      std::any_of(scans.begin(), scans.end(), [](const BoundingScan& scan) { return scan.used != 0; });
  return of_triple ? std::span<const std::size_t>(kAddedToTriple) : kAddedToBox;
}

RefinedPose refineInRounds(const GaussianPose& sensor, std::span<const BoundingScan> scans, double gate, int least,
                           GatedLandmarks& scratch)
{
  RefinedPose result{sensor};
  const std::span<const std::size_t> added = addedBy(scans);
  for (std::size_t round = 0;; ++round)
  {
    const bool growing = round < added.size();
    Matrix3d information = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    result.inliers = 0;
    result.operations += kOfRound;
    for (const BoundingScan& scan : scans)
    {
      landmarkGates(result.sensor, scan, gate, scratch);
      Associations found{};
      result.inliers += associate(scratch, *scan.table, static_cast<float>(gate * gate), found, result.operations);
      const float largest = growing ? largestVariance(found, scan, scratch, added[round]) : 0;
      for (int bit = 0; bit < scan.table->size(); ++bit)
      {
        const Association& e = found[static_cast<std::size_t>(bit)];
        if (e.candidates == 0) continue;
        result.operations += kOfRow;
        const bool own = (scan.used >> bit & 1U) != 0;
        if (growing && !own && (e.candidates > 1 || scratch.variance[e.landmark] > largest)) continue;
        const Vector3d row(scratch.ex[e.landmark], scratch.ey[e.landmark], -scratch.w[e.landmark]);
        const double weight = 1 / square(scan.table->bearing(bit).std);
        information += weight * row * row.transpose();
        gradient += weight * e.residual * row;
      }
    }
    if (round == 0) result.enough_at_start = result.inliers >= least;
    if (result.inliers < least || round == added.size() + kRoundsOnAll) return result;
    const Eigen::LDLT<Matrix3d> factors(information);
    if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0)) return result;
    const Vector3d step = factors.solve(gradient);
    Pose2& pose = result.sensor.mean;
    pose = {pose.x - step.x(), pose.y - step.y(), wrap(pose.phi - step.z())};
    result.sensor.covariance = factors.solve(Matrix3d::Identity());
    result.refined = true;
  }
}
}  // namespace

RefinedPose refineOnInliers(const GaussianPose& sensor, std::span<const BoundingScan> scans, double gate, int least,
                            GatedLandmarks& scratch)
{
  RefinedPose refined = refineInRounds(sensor, scans, gate, least, scratch);
  WorkCounter::add(refined.operations);
  return refined;
}
}  // namespace mrpt_ext
