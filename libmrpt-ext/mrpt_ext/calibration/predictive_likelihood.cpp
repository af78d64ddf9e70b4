#include "mrpt_ext/calibration/predictive_likelihood.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/calibration/outlier_model.h"
#include "mrpt_ext/calibration/trajectory_model.h"
#include "mrpt_ext/geometry/log_probability.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStartStd = 0.5, kStartStdPhi = 0.3;  // [m], [rad] of the first guess
constexpr double kMostMisfit = 10;                     // standard deviations of a reading that count at the start
constexpr double kLeastInliers = 0.6;                  // of those expected; with fewer the filter starts again
constexpr double kInlierMemory = 8;                    // readings of their mean
constexpr Eigen::Index kTimeBlocks = 20, kLeastTimeBlocks = 8;

std::vector<CalibrationUnknown> unknownsOf(const RecordingModel& model)
{
  std::vector<CalibrationUnknown> unknowns;
  for (const AssumedError& error : model.errors) unknowns.push_back(error.unknown);
  return unknowns;
}

class PredictionFilter
{
 public:
  PredictionFilter(const CalibrationProblem& problem, const RecordingModel& assumed)
      : problem_(problem),
        assumed_(assumed),
        model_(problem, unknownsOf(assumed)),
        errors_(static_cast<Eigen::Index>(assumed.errors.size())),
        covariance_(Eigen::MatrixXd::Zero(3 + errors_.size(), 3 + errors_.size())),
        longest_(longestRanges(problem))
  {
    for (Eigen::Index i = 0; i < errors_.size(); ++i)
    {
      errors_[i] = assumed.errors[static_cast<std::size_t>(i)].mean;
      covariance_(3 + i, 3 + i) = square(assumed.errors[static_cast<std::size_t>(i)].std);
    }
    model_.setErrors(errors_);
  }

  /// At the first guess of pose `k`, whose heading took up an offset of bearings: turned by that offset which its
  /// readings, from `reading` on, fit best with.
  void start(std::size_t k, std::size_t reading)
  {
    pose_ = problem_.poses[k].pose;
    pose_.phi = wrap(pose_.phi + startTurn(k, reading));
    covariance_.topRows<3>().setZero();
    covariance_.leftCols<3>().setZero();
    covariance_.diagonal().head<3>() << square(kStartStd), square(kStartStd), square(kStartStdPhi);
    inliers_ = expected_inliers_ = 1;
  }

  /// From pose `k - 1` to pose `k`, whose readings begin with `reading`.
  void moveTo(std::size_t k, std::size_t reading)
  {
    const bool tied = problem_.poses[k].since_previous.has_value();
    if (!tied || inliers_ < kLeastInliers * expected_inliers_) return start(k, reading);
    const MotionPrediction motion = model_.motion(k);
    const Matrix2d to_map = rotation(pose_.phi);
    const Vector2d step = to_map * motion.moved.position();
    Eigen::MatrixXd transition = Eigen::MatrixXd::Identity(covariance_.rows(), covariance_.cols());
    transition(0, 2) = -step.y();
    transition(1, 2) = step.x();
    if (errors_.size() > 0)
    {
      transition.topRightCorner(2, errors_.size()) = to_map * motion.shared.topRows<2>();
      transition.block(2, 3, 1, errors_.size()) = motion.shared.row(2);
    }
    covariance_ = (transition * covariance_ * transition.transpose()).eval();
    Matrix3d rotated = Matrix3d::Identity();
    rotated.topLeftCorner<2, 2>() = to_map;
    covariance_.topLeftCorner<3, 3>() +=
        rotated * scattered(*problem_.poses[k].since_previous, assumed_.odometry) * rotated.transpose();
    const double seconds = problem_.poses[k].time - problem_.poses[k - 1].time;
    for (Eigen::Index i = 0; i < errors_.size(); ++i)
      covariance_(3 + i, 3 + i) += square(assumed_.errors[static_cast<std::size_t>(i)].std_per_sqrt_s) * seconds;
    pose_ = compose(pose_, motion.moved);
  }

  /// Log density of the reading, which then updates the filter.
  double take(const CalibrationReading& r)
  {
    const AssumedNoise& noise = assumed_.sensors[r.sensor];
    const double clutter = noise.outliers / (r.is_range ? longest_[r.sensor] : kTwoPi);
    const ReadingResidual row = model_.reading(r, pose_);
    Eigen::RowVectorXd slope(covariance_.cols());
    slope << row.own, row.shared;
    const Eigen::VectorXd spread = covariance_ * slope.transpose();
    const double variance = slope.dot(spread) + square(r.is_range ? noise.range : noise.bearing);
    const double inlier = (1 - noise.outliers) * std::exp(logNormal(row.residual, variance)) / r.std;
    const double density = inlier + clutter;
    const bool counts = inlier > clutter;
    inliers_ += (static_cast<double>(counts) - inliers_) / kInlierMemory;
    expected_inliers_ += (1 - noise.outliers - expected_inliers_) / kInlierMemory;
    if (counts) update(spread / variance, spread, row.residual);
    return std::log(std::max(density, std::numeric_limits<double>::min()));
  }

 private:
  [[nodiscard]] double startTurn(std::size_t k, std::size_t reading) const
  {
    const auto misfit = [&](double turn)
    {
      const Pose2 turned{pose_.x, pose_.y, wrap(pose_.phi + turn)};
      double sum = 0;
      for (std::size_t i = reading; i < problem_.readings.size() && problem_.readings[i].pose == k; ++i)
        sum += std::min(std::abs(model_.reading(problem_.readings[i], turned).residual), kMostMisfit);
      return sum;
    };
    double best = 0;
    for (Eigen::Index i = 0; i < errors_.size(); ++i)
      if (assumed_.errors[static_cast<std::size_t>(i)].unknown.parameter == CalibrationParameter::bearing_offset &&
          misfit(errors_[i]) < misfit(best))
        best = errors_[i];
    return best;
  }

  void update(const Eigen::VectorXd& gain, const Eigen::VectorXd& spread, double residual)
  {
    covariance_ -= gain * spread.transpose();
    covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
    pose_ = added(pose_, residual * gain.head<3>());
    if (errors_.size() == 0) return;
    errors_ += residual * gain.tail(errors_.size());
    model_.setErrors(errors_);
  }

  const CalibrationProblem& problem_;
  const RecordingModel& assumed_;
  TrajectoryModel model_;
  Pose2 pose_;
  Eigen::VectorXd errors_;
  Eigen::MatrixXd covariance_;  // of the pose, then of the errors
  std::vector<double> longest_;
  double inliers_ = 1, expected_inliers_ = 1;  // means over the last readings
};
}  // namespace

std::vector<double> predictiveLogDensities(const CalibrationProblem& problem, const RecordingModel& model,
                                           std::size_t first)
{
  PredictionFilter filter(problem, model);
  std::vector<double> densities(problem.readings.size(), 0);
  std::size_t next = 0;
  while (next < densities.size() && problem.readings[next].pose < first) ++next;
  for (std::size_t k = first; k < problem.poses.size(); ++k)
  {
    if (k == first)
      filter.start(k, next);
    else
      filter.moveTo(k, next);
    for (; next < densities.size() && problem.readings[next].pose == k; ++next)
      densities[next] = filter.take(problem.readings[next]);
  }
  return densities;
}

PredictiveGain predictiveGain(const CalibrationProblem& problem, std::size_t first, const std::vector<double>& better,
                              const std::vector<double>& worse)
{
  const auto poses = static_cast<Eigen::Index>(problem.poses.size() - std::min(first, problem.poses.size()));
  const Eigen::Index blocks = std::min(kTimeBlocks, poses);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(std::max<Eigen::Index>(blocks, 1));
  for (std::size_t i = 0; i < problem.readings.size(); ++i)
    if (const std::size_t pose = problem.readings[i].pose; pose >= first)
      sums[static_cast<Eigen::Index>(pose - first) * blocks / poses] += better[i] - worse[i];
  if (blocks < kLeastTimeBlocks) return {sums.sum(), std::numeric_limits<double>::infinity()};
  const auto count = static_cast<double>(blocks);
  return {sums.sum(), std::sqrt(count / (count - 1) * (sums.array() - sums.mean()).square().sum())};
}
}  // namespace mrpt_ext
