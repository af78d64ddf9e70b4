#include "mrpt_ext/solvers/pose_from_landmarks.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/solvers/minimal_solvers.h"
#include "mrpt_ext/solvers/pose_curvature.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kSeeds = 16;     // of which minima are sought
constexpr std::size_t kRedundant = 6;  // measurements, from which on a seed can be recognised as known
constexpr double kForetold = 0.3;      // relative accuracy of a foretold cost
constexpr double kSameMinimum = 1e-3;  // [standard deviations]
constexpr double kFarAway = 1e4;       // times the measured extent: nothing can be said there
constexpr double kAnyHeadingVariance = kPi * kPi / 3;
// What bends away goes with the square of the error, and squares have long tails: at three standard deviations of the
// error they are three standard deviations of their own when their variance is counted three times.
constexpr double kTail = 3;
constexpr double kFarOut = 3;  // [standard deviations] where the parabola is checked
constexpr DescentOptions kDescent{.max_iterations = 50, .relative_step = 1e-9};

struct Minimum
{
  Pose2 pose;
  NormalEquations<3> at;

  /// Squared distance of `other` in standard deviations.
  [[nodiscard]] double distance2(const Pose2& other) const
  {
    const Vector3d d(other.x - pose.x, other.y - pose.y, wrap(other.phi - pose.phi));
    return d.dot(at.hessian * d);
  }
};

Minimum refined(const PoseResiduals& rows, const Pose2& start)
{
  Minimum minimum{start, rows.model(start)};
  const auto improved = [&rows](const Pose2& next, double bound) -> std::optional<NormalEquations<3>>
  {
    NormalEquations<3> there = rows.model(next);
    if (!(there.cost < bound)) return std::nullopt;
    return there;
  };
  descendFrom<3>(minimum.pose, minimum.at, improved, added, kDescent);
  return minimum;
}

/// All distinct minima that the seeds lead to, lowest first. A seed whose cost is what the parabola about a minimum
/// foretells belongs to that minimum and need not be followed; with little redundancy that may be chance.
std::vector<Minimum> findMinima(const PoseResiduals& rows, std::span<const PoseGuess> seeds)
{
  std::vector<Minimum> minima;
  for (const PoseGuess& seed : seeds)
  {
    const auto foretells = [&](const Minimum& m)
    {
      const double rise = m.distance2(seed.pose);
      return std::abs(seed.rough_cost - m.at.cost - rise) <= kForetold * rise;
    };
    if (rows.size() >= kRedundant && std::any_of(minima.begin(), minima.end(), foretells)) continue;
    const Minimum found = refined(rows, seed.pose);
    const auto same = [&](const Minimum& m) { return m.distance2(found.pose) <= square(kSameMinimum); };
    if (std::none_of(minima.begin(), minima.end(), same)) minima.push_back(found);
  }
  std::stable_sort(minima.begin(), minima.end(),
                   [](const Minimum& a, const Minimum& b) { return a.at.cost < b.at.cost; });
  return minima;
}

/// Side of the square over which landmarks and robot would be spread as evenly as they are: sqrt(6) times their
/// standard deviation.
double sceneExtent(std::span<const PoseMeasurement> measurements, const Vector2d& robot)
{
  Vector2d sum = Vector2d::Zero();
  double squares = 0, count = 1;
  for (const PoseMeasurement& m : measurements)
  {
    if (m.kind == PoseMeasurement::Kind::heading) continue;
    const Vector2d d = m.landmark - robot;
    sum += d;
    squares += d.squaredNorm();
    count += 1;
  }
  return count > 1 ? std::sqrt(6 * std::max(0.0, squares - sum.squaredNorm() / count) / (count - 1)) : 0;
}

/// Largest length among the measurements: between landmarks, of a range, to a sensor on the robot.
double measuredExtent(const PoseResiduals& rows)
{
  double extent = 0;
  for (const PoseResidual& m : rows.sightings())
    extent = std::max({extent, (m.landmark - rows.sightings().front().landmark).norm(), m.offset.norm(), m.range});
  return extent;
}

/// Probability that a chi-square variable exceeds `chi2` (Wilson and Hilferty 1931).
double chiSquareTail(double chi2, int degrees_of_freedom)
{
  if (degrees_of_freedom <= 0) return 1;
  const double spread = 2.0 / (9 * degrees_of_freedom);
  const double z = (std::cbrt(chi2 / degrees_of_freedom) - 1 + spread) / std::sqrt(spread);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// Along the direction of the largest standard deviation, following the curved ridge of the likelihood: by which factor
/// does the cost rise less than the covariance predicts? Large where a second pose is almost a minimum of its own.
double stretchAt(const PoseResiduals& rows, const Minimum& minimum, const PoseCurvature& curvature)
{
  double stretch = 1;
  for (const double z : {-kFarOut, kFarOut})
  {
    const double cost = rows.model(added(minimum.pose, z * curvature.weakest + z * z * curvature.bend)).cost;
    stretch = std::max(stretch, z * z / std::max(cost - minimum.at.cost, 1e-9));
  }
  return stretch;
}

/// The measurements, and whether they determine the heading.
struct Problem
{
  std::span<const PoseMeasurement> measurements;
  bool heading_known = true;
  PoseResiduals rows;
  double offset = 0;  ///< longest, of a sensor that turns with an unknown heading [m]
};

/// Ranges determine a heading only if their sensors have different positions on the robot.
bool determinesHeading(std::span<const PoseMeasurement> measurements)
{
  const auto determines = [&](const PoseMeasurement& m)
  {
    return m.kind != PoseMeasurement::Kind::range ||
           (measurements.size() >= 3 && m.T_robot_sensor.position() != measurements.front().T_robot_sensor.position());
  };
  return std::any_of(measurements.begin(), measurements.end(), determines);
}

/// Without a heading the rows hold for the sensor, and its heading is called 0 with the spread of any heading.
Problem problemOf(std::span<const PoseMeasurement> measurements)
{
  if (determinesHeading(measurements)) return {measurements, true, PoseResiduals(measurements)};
  std::vector<PoseMeasurement> centred(measurements.begin(), measurements.end());
  double offset = 0;
  for (PoseMeasurement& m : centred)
  {
    offset = std::max(offset, m.T_robot_sensor.position().norm());
    m.T_robot_sensor = {};
  }
  Problem problem{measurements, false, PoseResiduals(centred), offset};
  problem.rows.addHeading(0, std::sqrt(kAnyHeadingVariance));
  return problem;
}

/// Nothing when the information there is singular, or the minimum ran off to where no landmark can be told from
/// another. Its probability is relative to a perfectly known pose of `lowest_chi2`.
std::optional<PoseCandidate> describe(const Problem& problem, const Minimum& minimum, double lowest_chi2,
                                      const IdentifiedPoseOptions& options)
{
  PoseCandidate result;
  result.pose.mean = minimum.pose;
  result.heading_known = problem.heading_known;
  result.chi2 = minimum.at.cost;
  result.information_ratio = informationRatio(minimum.at.hessian);
  const std::optional<Matrix3d> bound = covarianceFromInformation(minimum.at.hessian);
  const double spread = sceneExtent(problem.measurements, minimum.pose.position());
  if (!bound || !(spread < kFarAway * measuredExtent(problem.rows))) return std::nullopt;
  const double extent = options.extent > 0 ? options.extent : spread;
  result.relative_error = std::sqrt(bound->topLeftCorner<2, 2>().trace()) / extent;
  const PoseCurvature curvature = poseCurvature(problem.rows, minimum.pose, *bound);
  result.curvature = curvature.rms;
  result.stretch = stretchAt(problem.rows, minimum, curvature);
  result.pose.covariance = *bound + kTail * curvature.second_moment;
  result.pose.covariance.topLeftCorner<2, 2>() += square(problem.offset) * Matrix2d::Identity();
  result.probability = std::exp(-0.5 * (result.chi2 - lowest_chi2)) * std::sqrt(bound->determinant());
  return result;
}
}  // namespace

IdentifiedPose solvePoseFromLandmarks(std::span<const PoseMeasurement> measurements,
                                      const IdentifiedPoseOptions& options)
{
  IdentifiedPose result;
  result.status = SolveStatus::bad_input;
  if (!std::all_of(measurements.begin(), measurements.end(), isUsable)) return result;
  result.status = SolveStatus::too_few;
  const int needed = determinesHeading(measurements) ? 3 : 2;
  result.degrees_of_freedom = std::max(0, static_cast<int>(measurements.size()) - needed);
  if (static_cast<int>(measurements.size()) < needed) return result;

  const Problem problem = problemOf(measurements);
  const std::vector<Minimum> minima = findMinima(problem.rows, solveMinimalSubsets(problem.rows, kSeeds));
  for (const Minimum& minimum : minima)
    if (minimum.at.cost <= minima.front().at.cost + options.rival_chi2)
      if (const auto candidate = describe(problem, minimum, minima.front().at.cost, options))
        result.candidates.push_back(*candidate);
  result.status = SolveStatus::degenerate;
  if (result.candidates.empty()) return result;

  const PoseCandidate& best = result.candidates.front();
  double sum = 0;
  for (PoseCandidate& candidate : result.candidates) sum += candidate.probability;
  for (PoseCandidate& candidate : result.candidates) candidate.probability /= sum;
  result.consistency = chiSquareTail(best.chi2, result.degrees_of_freedom);
  const bool likeliest = best.chi2 <= minima.front().at.cost;  // the best fit may be a degenerate pose
  const bool sharp = likeliest && best.relative_error <= options.max_relative_error &&
                     best.curvature <= options.max_curvature && best.stretch <= options.max_stretch;
  if (sharp) result.status = result.consistency >= options.min_consistency ? SolveStatus::ok : SolveStatus::none;
  return result;
}
}  // namespace mrpt_ext
