#include "mrpt_ext/calibration/self_calibration.h"

#include <algorithm>

#include "mrpt_ext/calibration/trajectory_adjustment.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLeastReadings = 20;
constexpr int kRounds = 6, kStepsPerRound = 3, kLastSteps = 15;

bool isUsable(const CalibrationProblem& way, const std::vector<ErrorTerm>& terms)
{
  const auto pose_ok = [](const TrajectoryPose& p)
  { return std::isfinite(p.time) && isFinite(p.pose) && (!p.since_previous || p.since_previous->allFinite()); };
  const auto reading_ok = [&](const CalibrationReading& r)
  {
    return r.pose < way.poses.size() && r.sensor < way.sensors && r.place.allFinite() && isFinite(r.T_robot_sensor) &&
           std::isfinite(r.height) && std::isfinite(r.value) && r.std > 0;
  };
  const auto term_ok = [&](const ErrorTerm& t) { return isOfOdometry(t.kind) || t.sensor < way.sensors; };
  return std::all_of(way.poses.begin(), way.poses.end(), pose_ok) &&
         std::all_of(way.readings.begin(), way.readings.end(), reading_ok) &&
         std::all_of(terms.begin(), terms.end(), term_ok) &&
         std::is_sorted(way.poses.begin(), way.poses.end(),
                        [](const TrajectoryPose& a, const TrajectoryPose& b) { return a.time < b.time; });
}

double typicalRange(const CalibrationProblem& way, std::size_t sensor)
{
  std::vector<double> ranges;
  for (const CalibrationReading& r : way.readings)
    if (r.is_range && r.sensor == sensor) ranges.push_back(r.value);
  return ranges.empty() ? 1 : upperMedian(std::move(ranges));
}

/// A deviation above it makes the error useless.
double mostDeviation(const ErrorTerm& term, const CalibrationProblem& way)
{
  switch (term.kind)
  {
    case CalibrationParameter::delay:
      return 0.1;
    case CalibrationParameter::bearing_offset:
      return degToRad(3.0);
    case CalibrationParameter::range_offset:
      return 0.05 * typicalRange(way, term.sensor);
    case CalibrationParameter::range_scale:
    case CalibrationParameter::veer:
      return 0.05;
    case CalibrationParameter::distance_scale:
    case CalibrationParameter::rotation_scale:
      return 0.1;
  }
  return 0;
}

/// True when the robot moves by more than odometry errs: else scales and delays would be fitted to its noise.
bool moves(const CalibrationProblem& way, double way_scatter)
{
  constexpr double kStretch = 5, kLeast = 4;  // [s]; squared motion over its variance, per axis
  const OdometryPath path(way.odometry, {});
  Matrix3d noise = Matrix3d::Zero();
  double sum = 0, axes = 0;
  for (std::size_t k = 1, first = 0; k < way.poses.size(); ++k)
  {
    const bool tied = way.poses[k].since_previous.has_value(), last = k + 1 == way.poses.size();
    if (tied) noise += *way.poses[k].since_previous;
    if (tied && !last && way.poses[k].time - way.poses[first].time < kStretch) continue;
    const Vector3d motion = path.between(way.poses[first].time, way.poses[tied ? k : k - 1].time).increment.vector();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(noise(axis, axis) > 0)) continue;
      sum += square(motion[axis] / way_scatter) / noise(axis, axis);
      ++axes;
    }
    noise.setZero();
    first = k;
  }
  return sum > kLeast * axes;
}

/// Scatters and adjustment in turns, then the adjustment alone.
bool settle(TrajectoryAdjustment& adjuster, int rounds)
{
  for (int k = 0; k < rounds; ++k)
    if (!adjuster.estimateScatters() || !adjuster.descend(kStepsPerRound)) return false;
  return adjuster.descend(kLastSteps);
}

/// The best of several starts for the delays, all the same for a start.
bool tryDelays(TrajectoryAdjustment& adjuster)
{
  const std::vector<ErrorTerm>& terms = adjuster.model().terms();
  const auto is_delay = [](const ErrorTerm& t) { return t.kind == CalibrationParameter::delay; };
  if (std::none_of(terms.begin(), terms.end(), is_delay)) return true;
  TrajectoryAdjustment best = adjuster;
  if (!best.descend(kStepsPerRound)) return false;
  double lowest = best.cost();
  for (const double start : {-1.0, -0.5, 0.5, 1.0})
  {
    TrajectoryAdjustment other = adjuster;
    Eigen::VectorXd errors = adjuster.model().errors();
    for (std::size_t k = 0; k < terms.size(); ++k)
      if (is_delay(terms[k])) errors[static_cast<Eigen::Index>(k)] += start;
    other.restart(adjuster, errors);
    if (!other.descend(kStepsPerRound) || !(other.cost() < lowest)) continue;
    lowest = other.cost();
    best.restart(other, other.model().errors());
  }
  adjuster.restart(best, best.model().errors());
  return true;
}

/// The error that is told worst, over what it may be; nothing when all are told.
std::optional<std::size_t> worstOf(const TrajectoryAdjustment& adjuster, const Eigen::VectorXd& deviations,
                                   const CalibrationProblem& way)
{
  std::optional<std::size_t> worst;
  double most = 1;
  for (std::size_t k = 0; k < adjuster.model().terms().size(); ++k)
  {
    const double excess = deviations[static_cast<Eigen::Index>(k)] / mostDeviation(adjuster.model().terms()[k], way);
    if (excess < most) continue;
    most = excess;
    worst = k;
  }
  return worst;
}

Eigen::VectorXd without(const Eigen::VectorXd& values, std::size_t number)
{
  const auto k = static_cast<Eigen::Index>(number);
  Eigen::VectorXd rest(values.size() - 1);
  rest << values.head(k), values.tail(values.size() - 1 - k);
  return rest;
}
}  // namespace

RecordingErrors calibrate(const CalibrationProblem& way, const std::vector<ErrorTerm>& terms)
{
  RecordingErrors result;
  for (const ErrorTerm& term : terms) result.errors.push_back({.term = term});
  result.status = SolveStatus::bad_input;
  if (!isUsable(way, terms)) return result;
  result.status = SolveStatus::too_few;
  if (way.readings.size() < std::max(kLeastReadings, 3 * terms.size())) return result;
  result.status = SolveStatus::degenerate;

  std::vector<ErrorTerm> left = terms;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < terms.size(); ++k) numbers.push_back(k);
  std::optional<TrajectoryAdjustment> adjuster(std::in_place, way, left);
  if (!settle(*adjuster, 2)) return result;
  if (!moves(way, adjuster->wayScatter()))
  {
    std::erase_if(numbers, [&](std::size_t k)
                  { return terms[k].kind == CalibrationParameter::delay || isOfOdometry(terms[k].kind); });
    left.clear();
    for (const std::size_t k : numbers) left.push_back(terms[k]);
    adjuster.emplace(way, left);
  }
  if (!tryDelays(*adjuster) || !settle(*adjuster, kRounds)) return result;
  for (;;)
  {
    const std::optional<Eigen::VectorXd> deviations = adjuster->deviations();
    if (!deviations || !deviations->allFinite()) return result;
    for (std::size_t k = 0; k < left.size(); ++k)
    {
      const auto i = static_cast<Eigen::Index>(k);
      result.errors[numbers[k]] = {left[k], true, adjuster->model().errors()[i], (*deviations)[i]};
    }
    const std::optional<std::size_t> worst = worstOf(*adjuster, *deviations, way);
    if (!worst) break;
    const auto at = static_cast<std::ptrdiff_t>(*worst);
    EstimatedError& held = result.errors[numbers[*worst]];
    held.observable = false;
    held.value = 0;
    const Eigen::VectorXd errors = without(adjuster->model().errors(), *worst);
    left.erase(left.begin() + at);
    numbers.erase(numbers.begin() + at);
    TrajectoryAdjustment fewer(way, left);
    fewer.restart(*adjuster, errors);
    if (!settle(fewer, 2)) return result;
    adjuster.emplace(std::move(fewer));
  }
  result.poses = adjuster->poses();
  result.scatter = adjuster->scatters();
  result.misfits = adjuster->misfits();
  result.way_scatter = adjuster->wayScatter();
  result.iterations = adjuster->steps();
  result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
