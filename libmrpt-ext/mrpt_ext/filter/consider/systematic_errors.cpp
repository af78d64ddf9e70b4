#include "mrpt_ext/filter/consider/systematic_errors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/filter/consider/place_variance.h"

namespace mrpt_ext
{
namespace
{
enum OfOdometry : Eigen::Index
{
  veer_error,
  drift_error,
  centre_x_error,
  centre_y_error,
  odometry_errors
};
enum OfSensor : Eigen::Index
{
  delay_error,
  bearing_offset_error,
  range_offset_error,
  range_scale_error,
  lever_x_error,
  lever_y_error,
  sensor_errors
};
constexpr double kParameterMemory = 600;  // [s] after which parameters may have changed

// What is plausible before anything was measured, in the order above; of lever arms where no deviation is assumed.
constexpr std::array<double, odometry_errors> kOdometryPrior = {degToRad(5.0), degToRad(1.0), 0.1, 0.1};
constexpr std::array<double, sensor_errors> kSensorPrior = {0.2, degToRad(5.0), 0.3, 0.1, 0.1, 0.1};

/// What is left of chi square of the parameters beyond what chance makes of as many that are zero, two standard
/// deviations above its mean.
double significantShare(const LinearEvidence& evidence, const Eigen::VectorXd& plausible)
{
  Eigen::MatrixXd with_prior = evidence.information;
  with_prior.diagonal() += plausible.cwiseAbs2().cwiseInverse();
  const Eigen::VectorXd parameters = with_prior.llt().solve(evidence.weighted);
  const auto count = static_cast<double>(parameters.size());
  const double by_chance = count + 2 * std::sqrt(2 * count), chi2 = parameters.dot(evidence.information * parameters);
  return chi2 > by_chance ? 1 - by_chance / chi2 : 0;
}

double priorStd(Eigen::Index parameter)
{
  return parameter < odometry_errors
             ? kOdometryPrior[static_cast<std::size_t>(parameter)]
             : kSensorPrior[static_cast<std::size_t>((parameter - odometry_errors) % sensor_errors)];
}

/// [m] The largest that is given for a sensor: how well places on the robot are known.
double leverArmStd(const std::vector<SensorStds>& sensors)
{
  double largest = 0;
  for (const SensorStds& given : sensors) largest = std::max(largest, given.lever_arm);
  return largest;
}

Eigen::Index firstOf(std::size_t sensor) { return odometry_errors + sensor_errors * static_cast<Eigen::Index>(sensor); }
std::size_t sensorOf(Eigen::Index parameter)
{
  return static_cast<std::size_t>((parameter - odometry_errors) / sensor_errors);
}
}  // namespace

SystematicErrors::SystematicErrors(Eigen::Index size, bool given) : started_(given), response_(size, 0), velocity_(size)
{
  resize(odometry_errors);
}

void SystematicErrors::resize(Eigen::Index parameters)
{
  const Eigen::Index before = response_.cols(), more = parameters - before;
  if (more <= 0) return;
  response_.conservativeResize(Eigen::NoChange, parameters);
  response_.rightCols(more).setZero();
  information_.conservativeResizeLike(Eigen::MatrixXd::Zero(parameters, parameters));
  weighted_.conservativeResizeLike(Eigen::VectorXd::Zero(parameters));
  by_noise_.conservativeResizeLike(Eigen::VectorXd::Zero(parameters));
  known_.mean.conservativeResizeLike(Eigen::VectorXd::Zero(parameters));
  known_.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(parameters, parameters));
}

void SystematicErrors::resize(const LinearStep& step)
{
  for (const InnovationRow& row : step.rows) resize(firstOf(row.source.sensor + 1));
  sensor_stds_ = step.sensor_stds;
}

void SystematicErrors::update(const LinearStep& step)
{
  resize(step);
  if (!started_) share(step);
  predict(step);
  velocity_.predict(step);
  const Eigen::MatrixXd by_parameters = measurementDerivatives(step);
  learn(step, by_parameters);
  response_ = (step.remaining * response_).eval();
  for (std::size_t i = 0; i < step.rows.size(); ++i)
    response_ += step.gains[i] * by_parameters.row(static_cast<Eigen::Index>(i));
  velocity_.correct(step);
  estimate();
}

void SystematicErrors::restart()
{
  started_ = false;
  response_.setZero();
  velocity_.restart();
}

void SystematicErrors::start(const LinearStep& step)
{
  resize(step);
  velocity_.predict(step);
  share(step);
  estimate();
}

// The readings that the estimate started from were taken where the sensors are, not where they are said to be, and when
// the robot was further back: by their share the whole estimate is beside the robot by as much.
void SystematicErrors::share(const LinearStep& step)
{
  if (step.rows.empty()) return;
  started_ = true;
  const double all = step.information.topLeftCorner<2, 2>().trace();
  for (std::size_t sensor = 0; sensor < step.sensor_information.size(); ++sensor)
  {
    const double share = step.sensor_information[sensor].topLeftCorner<2, 2>().trace() / all;
    if (share > 0 && step.sensor_stds[sensor].lever_arm > 0)
      response_.block<2, 2>(0, firstOf(sensor) + lever_x_error) = share * rotation(step.before.mean[2]);
    if (share > 0 && step.sensor_stds[sensor].delay > 0)
      response_.block<3, 1>(0, firstOf(sensor) + delay_error) = -share * velocity_.velocity(step);
  }
}

std::vector<Eigen::Index> SystematicErrors::assumedPlaces() const
{
  std::vector<Eigen::Index> places;
  for (std::size_t sensor = 0; sensor < sensor_stds_.size() && firstOf(sensor + 1) <= response_.cols(); ++sensor)
    if (sensor_stds_[sensor].lever_arm_is_assumed)
      for (const Eigen::Index axis : {lever_x_error, lever_y_error}) places.push_back(firstOf(sensor) + axis);
  if (!places.empty()) places.insert(places.end(), {centre_x_error, centre_y_error});
  return places;
}

PriorStds SystematicErrors::prior() const
{
  const Eigen::Index parameters = response_.cols();
  PriorStds prior{Eigen::VectorXd::Zero(parameters), Eigen::VectorXd(parameters)};
  for (Eigen::Index k = 0; k < parameters; ++k) prior.most[k] = priorStd(k);
  const auto centre = Eigen::seqN(centre_x_error, 2);
  if (const double given = leverArmStd(sensor_stds_); given > 0)
    prior.least(centre) = prior.most(centre) = Vector2d::Constant(given);
  for (std::size_t sensor = 0; sensor < sensor_stds_.size() && firstOf(sensor + 1) <= parameters; ++sensor)
  {
    const auto lever = Eigen::seqN(firstOf(sensor) + lever_x_error, 2);
    const Eigen::Index delay = firstOf(sensor) + delay_error;
    const SensorStds& given = sensor_stds_[sensor];
    if (given.lever_arm > 0) prior.least(lever) = prior.most(lever) = Vector2d::Constant(given.lever_arm);
    prior.least[delay] = given.delay;
    prior.most[delay] = std::max(prior.most[delay], given.delay);
  }
  const std::vector<Eigen::Index> assumed = assumedPlaces();
  prior.least(assumed).setConstant(place_std_);
  prior.most(assumed).setConstant(place_std_);
  return prior;
}

void SystematicErrors::predict(const LinearStep& step)
{
  // The estimate has missed what odometry did not tell.
  response_ = (step.motion_jacobian * response_).eval();
  const PathMoments moments = momentsOf(step.motion);
  const Matrix3d to_world = composeJacobianSecond(step.before.pose());
  response_.col(veer_error).head<3>() -= to_world * moments.by_length;
  response_.col(drift_error).head<3>() -= to_world * moments.by_time;
  // Turns alone cannot tell it from a lever arm: where no deviation of these is given, it is none.
  if (leverArmStd(sensor_stds_) > 0)
    response_.block<2, 2>(0, centre_x_error) -= rotation(step.predicted.mean[2]) - rotation(step.before.mean[2]);
}

Eigen::MatrixXd SystematicErrors::measurementDerivatives(const LinearStep& step) const
{
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(step.rows.size()), response_.cols());
  const Matrix2d R = rotation(step.predicted.mean[2]);
  const Vector3d velocity = velocity_.velocity(step);
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const InnovationRow& row = step.rows[i];
    const Eigen::Vector3d by_pose = row.row.jacobian.head<3>().transpose();
    auto derivative = derivatives.row(static_cast<Eigen::Index>(i)).segment<sensor_errors>(firstOf(row.source.sensor));
    derivative[delay_error] = -by_pose.dot(velocity);
    if (row.source.is_bearing) derivative[bearing_offset_error] = 1;
    if (!row.source.is_bearing) derivative[range_offset_error] = 1;
    if (!row.source.is_bearing) derivative[range_scale_error] = row.measured;
    const Vector2d by_lever = R.transpose() * by_pose.head<2>();
    derivative[lever_x_error] = by_lever.x();
    derivative[lever_y_error] = by_lever.y();
  }
  return derivatives;
}

void SystematicErrors::learn(const LinearStep& step, const Eigen::MatrixXd& by_parameters)
{
  const double kept = std::exp(-std::max(0.0, step.motion.duration) / kParameterMemory);
  information_ *= kept;
  weighted_ *= kept;
  by_noise_ *= kept;
  const Eigen::MatrixXd information_before = information_;
  const Eigen::VectorXd weighted_before = weighted_;
  // The innovations share the error of the predicted pose: their covariance is R + H P H^T, inverted by the lemma.
  const Eigen::Index size = step.predicted.mean.size(), parameters = response_.cols();
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(size, parameters);
  Eigen::VectorXd shared_residual = Eigen::VectorXd::Zero(size);
  double nis = 0;
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const KalmanRow& row = step.rows[i].row;
    const Eigen::RowVectorXd visible = by_parameters.row(static_cast<Eigen::Index>(i)) - row.jacobian * response_;
    information_.noalias() += visible.transpose() * visible / row.variance;
    weighted_.noalias() += visible.transpose() * (row.residual / row.variance);
    nis += square(row.residual) / row.variance;
    shared.noalias() += row.jacobian.transpose() * visible / row.variance;
    shared_residual.noalias() += row.jacobian.transpose() * (row.residual / row.variance);
  }
  information_.noalias() -= shared.transpose() * step.posterior * shared;
  weighted_.noalias() -= shared.transpose() * (step.posterior * shared_residual);
  const Eigen::MatrixXd more = information_ - information_before;
  score_variance_.add(step.motion.duration, weighted_ - weighted_before - more * known_.mean, more.diagonal(), kept);
  if (step.rows.empty()) return;
  // Of the stated noise as much as the innovations show.
  nis -= shared_residual.dot(step.posterior * shared_residual);
  const double shown = nis / static_cast<double>(step.rows.size());
  for (Eigen::Index delay = odometry_errors; delay < parameters; delay += sensor_errors)
    by_noise_[delay] += shown * velocity_.expectedProduct(step, sensorOf(delay));
}

void SystematicErrors::estimate()
{
  LinearEvidence evidence{information_, weighted_};
  // As little of a delay as the noise of odometry leaves.
  const RelevantParameters before = relevance_.posterior(evidence);
  for (Eigen::Index k = 0; k < weighted_.size(); ++k)
  {
    const double by_noise = before.covariance(k, k) * by_noise_[k];
    if (by_noise != 0) evidence.weighted[k] -= std::clamp(before.mean[k] / by_noise, 0.0, 1.0) * by_noise_[k];
  }
  // How well they are known: by errors of readings that last.
  const Eigen::VectorXd worth = score_variance_.worth(weighted_.size());
  const Eigen::VectorXd scale = worth.cwiseSqrt();
  const LinearEvidence lasting{scale.asDiagonal() * evidence.information * scale.asDiagonal(),
                               evidence.weighted.cwiseProduct(worth)};
  if (const std::vector<Eigen::Index> places = assumedPlaces(); !places.empty())
    place_std_ = std::sqrt(placeVariance(relevance_.marginal(lasting, places), kAssumedLeverArmStd));
  const PriorStds prior = this->prior();
  // What has a prior of its own needs no evidence.
  significant_ = (prior.least.array() > 0)
                     .select(Eigen::ArrayXd::Ones(prior.least.size()), significantShare(evidence, prior.most))
                     .matrix();
  relevance_.update(lasting, prior);
  known_ = relevance_.posterior(lasting);
}

KalmanMatrix SystematicErrors::added() const
{
  if (significant_.size() != response_.cols()) return KalmanMatrix::Zero(response_.rows(), response_.rows());
  const Eigen::MatrixXd response = response_ * significant_.cwiseSqrt().asDiagonal();
  const KalmanVector shift = response * known_.mean;
  return shift * shift.transpose() + response * known_.covariance * response.transpose();
}

KalmanMatrix SystematicErrors::assumed() const
{
  const Eigen::VectorXd least = prior().least;
  if (least.size() != known_.covariance.rows()) return KalmanMatrix::Zero(response_.rows(), response_.rows());
  const Eigen::MatrixXd response = response_ * (least.array() > 0).cast<double>().matrix().asDiagonal();
  return response * known_.covariance * response.transpose();
}
}  // namespace mrpt_ext
