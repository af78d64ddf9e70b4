#include "mrpt_ext/calibration/self_calibration.h"

#include <algorithm>
#include <memory>

#include "mrpt_ext/calibration/measurement_times.h"
#include "mrpt_ext/calibration/parameter_limits.h"
#include "mrpt_ext/calibration/trajectory_adjustment.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLeastReadings = 20;
constexpr int kRounds = 6, kStepsPerRound = 3, kLastSteps = 15;
constexpr int kMostMoves = 3;
constexpr double kSmallDelay = 0.003;  // [s]

bool isUsable(const CalibrationProblem& problem, const std::vector<CalibrationUnknown>& unknowns)
{
  const auto pose_ok = [](const TrajectoryPose& p)
  {
    return std::isfinite(p.time) && isFinite(p.pose) && (!p.since_previous || scattered(*p.since_previous).allFinite());
  };
  const auto reading_ok = [&](const CalibrationReading& r)
  {
    return r.pose < problem.poses.size() && r.sensor < problem.sensors && r.landmark.allFinite() &&
           isFinite(r.T_robot_sensor) && std::isfinite(r.height) && std::isfinite(r.value) && r.std > 0;
  };
  const auto unknown_ok = [&](const CalibrationUnknown& t)
  { return isOfOdometry(t.parameter) || t.sensor < problem.sensors; };
  return std::all_of(problem.poses.begin(), problem.poses.end(), pose_ok) &&
         std::all_of(problem.readings.begin(), problem.readings.end(), reading_ok) &&
         std::all_of(unknowns.begin(), unknowns.end(), unknown_ok) &&
         std::is_sorted(problem.poses.begin(), problem.poses.end(),
                        [](const TrajectoryPose& a, const TrajectoryPose& b) { return a.time < b.time; });
}

/// True when the robot moves by more than the error of odometry: else scales and delays would be fitted to its noise.
bool moves(const CalibrationProblem& problem, const PerMotionNoise<double>& odometry_scatter)
{
  constexpr double kStretch = 5, kLeast = 4;  // [s]; squared motion over its variance, per axis
  const OdometryPath path(problem.odometry, {});
  Matrix3d noise = Matrix3d::Zero();
  double sum = 0, axes = 0;
  for (std::size_t k = 1, first = 0; k < problem.poses.size(); ++k)
  {
    const bool tied = problem.poses[k].since_previous.has_value(), last = k + 1 == problem.poses.size();
    if (tied) noise += scattered(*problem.poses[k].since_previous, odometry_scatter);
    if (tied && !last && problem.poses[k].time - problem.poses[first].time < kStretch) continue;
    const Vector3d motion =
        path.between(problem.poses[first].time, problem.poses[tied ? k : k - 1].time).increment.vector();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(noise(axis, axis) > 0)) continue;
      sum += square(motion[axis]) / noise(axis, axis);
      ++axes;
    }
    noise.setZero();
    first = k;
  }
  return sum > kLeast * axes;
}

/// Alternates between scatters and adjustment, then the adjustment alone.
bool settle(TrajectoryAdjustment& adjuster, int rounds)
{
  for (int k = 0; k < rounds; ++k)
    if (!adjuster.descend(kStepsPerRound) || !adjuster.estimateScatters()) return false;
  return adjuster.descend(kLastSteps);
}

/// Chooses the best of several starts for the delays, the same start for all sensors.
bool tryDelays(TrajectoryAdjustment& adjuster)
{
  const std::vector<CalibrationUnknown>& unknowns = adjuster.model().unknowns();
  const auto is_delay = [](const CalibrationUnknown& t) { return t.parameter == CalibrationParameter::delay; };
  if (std::none_of(unknowns.begin(), unknowns.end(), is_delay)) return true;
  TrajectoryAdjustment best = adjuster;
  if (!best.descend(kStepsPerRound)) return false;
  double lowest = best.cost();
  for (const double start : {-1.0, -0.5, 0.5, 1.0})
  {
    TrajectoryAdjustment other = adjuster;
    Eigen::VectorXd errors = adjuster.model().errors();
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      if (is_delay(unknowns[k])) errors[static_cast<Eigen::Index>(k)] += start;
    other.restart(adjuster, errors);
    if (!other.descend(kStepsPerRound) || !(other.cost() < lowest)) continue;
    lowest = other.cost();
    best.restart(other, other.model().errors());
  }
  adjuster.restart(best, best.model().errors());
  return true;
}

/// The recording with its poses at the measurements, and its adjustment.
struct MovedRecording
{
  std::unique_ptr<MeasuredRecording> measured;
  std::unique_ptr<TrajectoryAdjustment> adjuster;
};

std::vector<double> delaysOf(const TrajectoryModel& model, std::size_t sensors)
{
  std::vector<double> delays(sensors, 0);
  for (std::size_t k = 0; k < model.unknowns().size(); ++k)
    if (model.unknowns()[k].parameter == CalibrationParameter::delay)
      delays[model.unknowns()[k].sensor] = model.errors()[static_cast<Eigen::Index>(k)];
  return delays;
}

bool areClose(const std::vector<double>& delays, const std::vector<double>& others)
{
  return std::equal(delays.begin(), delays.end(), others.begin(),
                    [](double a, double b) { return std::abs(a - b) < kSmallDelay; });
}

/// Moves the poses to the measurements and adjusts again until the delays do not change. `moved` stays empty when there
/// is no delay. False when something is undetermined.
bool moveToMeasurements(const CalibrationProblem& problem, const std::vector<CalibrationUnknown>& unknowns,
                        const TrajectoryAdjustment& start, MovedRecording& moved)
{
  std::vector<double> known(problem.sensors, 0);
  for (int k = 0; k < kMostMoves; ++k)
  {
    const TrajectoryAdjustment& last = moved.adjuster ? *moved.adjuster : start;
    const std::vector<double> delays = delaysOf(last.model(), problem.sensors);
    if (areClose(delays, known)) return true;
    known = delays;
    auto measured = std::make_unique<MeasuredRecording>(atMeasurementTimes(problem, delays));
    auto adjuster = std::make_unique<TrajectoryAdjustment>(measured->problem, unknowns);
    adjuster->continueFrom(last);
    if (!settle(*adjuster, kRounds)) return false;
    moved.adjuster = std::move(adjuster);
    moved.measured = std::move(measured);
  }
  return true;
}

/// `covariance` of the unknowns `numbers`, in the order of `errors`.
Eigen::MatrixXd observableOnes(const Eigen::MatrixXd& covariance, const std::vector<std::size_t>& numbers,
                               const std::vector<ParameterEstimate>& errors)
{
  const auto size = static_cast<Eigen::Index>(errors.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  all(numbers, numbers) = covariance;
  for (Eigen::Index k = 0; k < size; ++k)
    if (!errors[static_cast<std::size_t>(k)].observable)
    {
      all.row(k).setZero();
      all.col(k).setZero();
    }
  return all;
}

std::vector<double> inLoggedOrder(const std::vector<double>& values, const std::vector<std::size_t>& numbers)
{
  std::vector<double> ordered(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) ordered[numbers[i]] = values[i];
  return ordered;
}
}  // namespace

CalibrationResult calibrate(const CalibrationProblem& problem, const std::vector<CalibrationUnknown>& unknowns)
{
  CalibrationResult result;
  for (const CalibrationUnknown& unknown : unknowns) result.errors.push_back({.unknown = unknown});
  result.status = SolveStatus::bad_input;
  if (!isUsable(problem, unknowns)) return result;
  result.status = SolveStatus::too_few;
  if (problem.readings.size() < std::max(kLeastReadings, 3 * unknowns.size())) return result;
  result.status = SolveStatus::degenerate;

  std::vector<CalibrationUnknown> left = unknowns;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < unknowns.size(); ++k) numbers.push_back(k);
  std::optional<TrajectoryAdjustment> adjuster(std::in_place, problem, left);
  if (!settle(*adjuster, 2)) return result;
  if (!moves(problem, adjuster->model().odometryScatter()))
  {
    std::erase_if(
        numbers, [&](std::size_t k)
        { return unknowns[k].parameter == CalibrationParameter::delay || isOfOdometry(unknowns[k].parameter); });
    left.clear();
    for (const std::size_t k : numbers) left.push_back(unknowns[k]);
    adjuster.emplace(problem, left);
  }
  if (!tryDelays(*adjuster) || !settle(*adjuster, kRounds)) return result;
  MovedRecording moved;
  if (!moveToMeasurements(problem, left, *adjuster, moved)) return result;
  if (moved.adjuster) adjuster.emplace(std::move(*moved.adjuster));
  adjuster->tellOutliers();
  if (!settle(*adjuster, kRounds)) return result;
  const std::optional<TrajectoryAdjustment::Uncertainty> found = adjuster->uncertainty();
  if (!found || !found->std.allFinite()) return result;
  for (std::size_t k = 0; k < left.size(); ++k)
  {
    const auto i = static_cast<Eigen::Index>(k);
    const bool observable = found->std[i] <= largestUsefulStd(problem, left[k]);
    result.errors[numbers[k]] = {left[k], observable, observable ? adjuster->model().errors()[i] : 0, found->std[i]};
  }
  result.covariance = observableOnes(found->covariance, numbers, result.errors);
  result.scatter = adjuster->scatters();
  result.misfits = moved.measured ? inLoggedOrder(adjuster->misfits(), moved.measured->readings) : adjuster->misfits();
  result.odometry_scatter = adjuster->model().odometryScatter();
  result.odometry_scatter_std = adjuster->odometryScatterStd();
  result.odometry_redundancy = adjuster->odometryRedundancy();
  result.iterations = adjuster->steps();
  result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
