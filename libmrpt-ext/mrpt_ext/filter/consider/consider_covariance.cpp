#include "mrpt_ext/filter/consider/consider_covariance.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/kalman/kalman_association.h"
#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr double kInnovationGate = 4;     // standard deviations
constexpr double kRemarkable = 1.5;       // times the stated standard deviation
constexpr double kClear = 0.5;            // probability of the association
constexpr std::size_t kMostSensors = 16;  // the others share the last place

/// The gains of all rows together, in information form: any number of rows, one inversion of the size of the state.
void solveGains(LinearStep& step, std::size_t sensors)
{
  const Eigen::Index size = step.predicted.mean.size();
  const KalmanMatrix I = KalmanMatrix::Identity(size, size);
  const KalmanMatrix& P = step.predicted.covariance;
  step.information = KalmanMatrix::Zero(size, size);
  step.sensor_information.assign(sensors, step.information);
  for (const InnovationRow& row : step.rows)
  {
    const KalmanMatrix of_row = row.row.jacobian.transpose() * row.row.jacobian / row.row.variance;
    step.information += of_row;
    step.sensor_information[row.source.sensor] += of_row;
  }
  step.remaining = KalmanMatrix(I + P * step.information).partialPivLu().inverse();
  step.posterior = step.remaining * P;
  for (const InnovationRow& row : step.rows)
    step.gains.push_back(step.posterior * row.row.jacobian.transpose() / row.row.variance);
}

Matrix3d positivePart(const Matrix3d& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(0.5 * (matrix + matrix.transpose()));
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() * solver.eigenvectors().transpose();
}
}  // namespace

ConsiderCovariance::ConsiderCovariance(MotionModel motion, BiasModel biases, const LandmarkTable& map,
                                       const std::optional<GaussianPose>& start)
    : motion_(motion),
      biases_(std::move(biases)),
      map_(map),
      default_max_range_(map.empty() ? 1 : defaultMaxRange(map)),
      persistent_(3 + static_cast<Eigen::Index>(biases_.size())),
      systematic_(3 + static_cast<Eigen::Index>(biases_.size()), start.has_value()),
      noise_(motion, 3 + static_cast<Eigen::Index>(biases_.size()))
{
  if (start) stated_ = startingState(*start, biases_);
}

void ConsiderCovariance::follow(std::optional<KalmanState> now, const Frame& frame, bool verified)
{
  if (stated_)
    update(linearise(*stated_, frame));
  else if (now)
  {
    Frame at_rest = frame;
    at_rest.motion = {};
    LinearStep step = linearise(*now, at_rest);
    step.motion = nominalMotion(motion_, frame.motion);
    systematic_.start(step);
    state();
  }
  if (!now) restart();
  if (now && verified) noise_.confirm();
  stated_ = std::move(now);
}

Frame ConsiderCovariance::withExcess(Frame frame) const
{
  frame.motion.excess = noise_.excess(frame.motion);
  return frame;
}

void ConsiderCovariance::restart()
{
  stated_.reset();
  persistent_.restart();
  systematic_.restart();
  noise_.restart();
  added_.setZero();
  assumed_.setZero();
  yaw_std_ = 0;
}

void ConsiderCovariance::update(const LinearStep& step)
{
  persistent_.update(step);
  systematic_.update(step);
  noise_.update(step, persistent_.lastingVariances(step));
  state();
}

void ConsiderCovariance::state()
{
  const Matrix3d systematic = systematic_.added().topLeftCorner<3, 3>();
  const Matrix3d lasting = persistent_.added().topLeftCorner<3, 3>();
  if (!systematic.allFinite() || !lasting.allFinite()) return restart();
  added_ = positivePart(lasting) + systematic;
  // The axes that the heading refers to are known no better than those of the sensors.
  yaw_std_ = 0;
  for (const SensorStds& given : sensor_stds_) yaw_std_ = std::max(yaw_std_, given.yaw);
  added_(2, 2) += square(yaw_std_);
  assumed_ = systematic_.assumed().topLeftCorner<3, 3>();
}

std::string ConsiderCovariance::finding(const Matrix3d& stated) const
{
  const double before = stated.topLeftCorner<2, 2>().trace(), more = added_.topLeftCorner<2, 2>().trace();
  const bool mostly_assumed = assumed_.topLeftCorner<2, 2>().trace() > 0.5 * more;
  std::string text;
  const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : "; ") + sentence; };
  if (std::sqrt(before + more) > kRemarkable * std::sqrt(before))
    add(formatted("%s: standard deviation %.3f m instead of %.3f m",
                  mostly_assumed ? "lever_arm_std_m, delay_std_s" : "errors that last", std::sqrt(before + more),
                  std::sqrt(before)));
  const double with = std::sqrt(stated(2, 2) + added_(2, 2)), without = std::sqrt(square(with) - square(yaw_std_));
  if (with > kRemarkable * without)
    add(formatted("yaw_std_deg: standard deviation %.1f deg instead of %.1f deg", radToDeg(with), radToDeg(without)));
  const double noise = std::sqrt(*std::max_element(noise_.factors().begin(), noise_.factors().end()));
  if (noise > kRemarkable) add(formatted("odometry errs %.1f times as much as stated", noise));
  return text;
}

LinearStep ConsiderCovariance::linearise(const KalmanState& before, const Frame& frame)
{
  LinearStep step{.time = frame.time, .motion = nominalMotion(motion_, frame.motion), .before = before};
  step.predicted = predict(before, biases_, motion_, frame.motion);
  step.motion_jacobian = motionJacobian(before, biases_, motion_, frame.motion);
  step.increment_noise = composeJacobianSecond(before.pose()) * incrementCovariance(motion_, frame.motion);
  const std::optional<Frame> affordable = affordableToUpdate(frame, map_, 1);
  for (const Reading& reading : scoredReadings(affordable ? *affordable : frame)) addRows(reading, step);
  step.sensor_stds = sensor_stds_;
  solveGains(step, sensors_.size());
  return step;
}

void ConsiderCovariance::addRows(const Reading& reading, LinearStep& step)
{
  const std::size_t sensor = indexOf(reading.sensor);
  sensor_stds_.resize(sensors_.size());
  const std::optional<double> lever_arm = reading.model.lever_arm_std;
  sensor_stds_[sensor] = {.lever_arm = lever_arm.value_or(kAssumedLeverArmStd),
                          .lever_arm_is_assumed = !lever_arm,
                          .delay = reading.model.delay_std,
                          .yaw = reading.model.yaw_std};
  for (const Detection& detection : reading.detections)
  {
    const Association found = associate(detection, reading, map_, step.predicted, biases_, default_max_range_);
    if (!(found.best > kClear)) continue;
    for (int k = 0; k < found.rows.count; ++k)
    {
      const bool is_bearing = detection.bearing && k == 0;
      InnovationRow row{.source = {sensor, is_bearing, found.landmark},
                        .row = found.rows.rows[static_cast<std::size_t>(k)],
                        .measured = is_bearing ? *detection.bearing : *detection.range};
      const KalmanRowVector& H = row.row.jacobian;
      row.variance = H.dot(step.predicted.covariance * H.transpose()) + row.row.variance;
      if (square(row.row.residual) < square(kInnovationGate) * row.variance) step.rows.push_back(std::move(row));
    }
  }
}

std::size_t ConsiderCovariance::indexOf(const std::string& sensor)
{
  const auto found = std::find(sensors_.begin(), sensors_.end(), sensor);
  const auto index = static_cast<std::size_t>(found - sensors_.begin());
  if (found == sensors_.end() && sensors_.size() < kMostSensors) sensors_.push_back(sensor);
  return std::min(index, kMostSensors - 1);
}
}  // namespace mrpt_ext
