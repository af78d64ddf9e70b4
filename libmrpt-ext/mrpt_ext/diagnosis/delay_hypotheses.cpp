#include "mrpt_ext/diagnosis/delay_hypotheses.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr std::array kDelays{-0.2, -0.1, -0.05, 0.0, 0.05, 0.1, 0.2, 0.4};  // [s]
constexpr double kGate2 = 16;                                               // squared standard deviations: an outlier
constexpr double kSignificantDelay = 5;                                     // standard errors
constexpr std::size_t kLeastDelayBlocks = 12;

/// Median time between two records of odometry [s], of the first thousand.
double periodOf(const Trajectory& odometry)
{
  std::vector<double> periods;
  for (std::size_t k = 1; k < std::min<std::size_t>(odometry.size(), 1000); ++k)
    periods.push_back(odometry[k].time - odometry[k - 1].time);
  return periods.empty() ? 0 : upperMedian(periods);
}

/// kDelays as multiples of the period of odometry, and at least one period: between its records odometry is
/// interpolated, which averages its noise, and a delay must not look right for that alone.
std::vector<double> delaysFor(double period)
{
  std::vector<double> delays(kDelays.begin(), kDelays.end());
  if (!(period > 0)) return delays;
  for (double& delay : delays)
    if (delay != 0) delay = std::copysign(period * std::max(1.0, std::round(std::abs(delay) / period)), delay);
  delays.erase(std::unique(delays.begin(), delays.end()), delays.end());
  return delays;
}
}  // namespace

ScalarMeasurement linearize(const MatchedMeasurement& m, const Pose2& robot)
{
  const Vector2d offset = m.T_robot_sensor.position();
  if (!m.is_range)
    return {wrap(m.value - predictBearing(robot, m.landmark, m.T_robot_sensor)),
            m.std,
            bearingJacobian(robot, m.landmark, offset),
            {}};
  const double flat = predictRange(robot, m.landmark, m.T_robot_sensor), range = std::hypot(flat, m.height);
  return {m.value - range, m.std, rangeJacobian(robot, m.landmark, offset) * (range > 0 ? flat / range : 0), {}};
}

DelayHypotheses::DelayHypotheses(const OdometryPath& odometry, const MotionModel& motion)
    : odometry_(odometry),
      delays_(delaysFor(periodOf(odometry.trajectory()))),
      none_(std::min_element(delays_.begin(), delays_.end(),
                             [](double a, double b) { return std::abs(a) < std::abs(b); }) -
            delays_.begin()),
      filters_(delays_.size(), BiasFreeFilter({}, motion)),
      blocks_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(delays_.size())))
{
}

void DelayHypotheses::start(const GaussianPose& pose, double time)
{
  for (BiasFreeFilter& filter : filters_) filter.start(pose);
  time_ = time;
}

void DelayHypotheses::predict(double time)
{
  for (std::size_t k = 0; k < delays_.size(); ++k)
    filters_[k].predict(odometry_.between(time_ - delays_[k], time - delays_[k]));
  time_ = time;
}

void DelayHypotheses::update(const MatchedMeasurement& matched, bool counts)
{
  for (std::size_t k = 0; k < delays_.size(); ++k)
  {
    const ScalarMeasurement measurement = linearize(matched, filters_[k].pose().mean);
    const SensitiveInnovation found = filters_[k].innovation(measurement);
    const double squared = square(found.value);
    if (counts) blocks_.open()[static_cast<Eigen::Index>(k)] -= std::min(squared, kGate2) / 2 + std::log(found.std);
    if (squared < kGate2) filters_[k].update(measurement);
  }
}

void DelayHypotheses::endFrame(bool counts)
{
  if (!counts) return;
  const BiasFreeFilter& filter = filters_[static_cast<std::size_t>(none_)];
  const OdometryMotion second = odometry_.between(time_ - 0.5, time_ + 0.5);
  const Vector3d moved{second.increment.x, second.increment.y, second.increment.phi};
  if (const Eigen::LLT<Matrix3d> factor(filter.pose().covariance); factor.info() == Eigen::Success)
  {
    Matrix3d to_map = Matrix3d::Identity();
    to_map.topLeftCorner<2, 2>() = rotation(filter.pose().mean.phi - second.increment.phi / 2);
    effect_ += factor.matrixL().solve(to_map * moved).squaredNorm() / 3;
    ++frames_;
  }
  blocks_.endItem();
}

/// Maximum of the parabola through the best delay and its neighbours; the best one itself at the ends.
double DelayHypotheses::refined(std::size_t best, const Eigen::VectorXd& log_likelihood) const
{
  if (best == 0 || best + 1 == delays_.size()) return delays_[best];
  const auto i = static_cast<Eigen::Index>(best);
  const double left = delays_[best - 1] - delays_[best], right = delays_[best + 1] - delays_[best],
               falls_left = (log_likelihood[i - 1] - log_likelihood[i]) / left,
               falls_right = (log_likelihood[i + 1] - log_likelihood[i]) / right;
  const double curvature = (falls_right - falls_left) / (right - left);
  return curvature < 0 ? delays_[best] - (falls_left - curvature * left) / (2 * curvature) : delays_[best];
}

std::optional<DelayFinding> DelayHypotheses::finding() const
{
  const std::vector<Eigen::VectorXd>& blocks = blocks_.complete();
  if (blocks.size() < kLeastDelayBlocks || frames_ == 0) return std::nullopt;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(delays_.size()));
  for (const Eigen::VectorXd& block : blocks) sum += block;
  Eigen::Index best = 0;
  const double most = sum.maxCoeff(&best);
  const double gain = most - sum[none_], mean = gain / static_cast<double>(blocks.size());
  double squares = 0;
  for (const Eigen::VectorXd& block : blocks) squares += square(block[best] - block[none_] - mean);
  if (best == none_ || !(gain > kSignificantDelay * std::sqrt(squares))) return std::nullopt;
  const double delay = refined(static_cast<std::size_t>(best), sum);
  return DelayFinding{delay, std::abs(delay) * std::sqrt(effect_ / frames_)};
}
}  // namespace mrpt_ext
