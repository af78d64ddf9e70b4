#include "mrpt_ext/calibration/trajectory_model.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
// [s] Long, so that the noise of odometry at a reading, which its link has too, is a small part of the speed: it would
// look like a change of speed, and bias the delay.
constexpr double kDelayChange = 0.15;
constexpr double kLeastLink = 1e-4;  // [m], [rad] smallest standard deviation of odometry per link

/// Number of a landmark's unknown, -1: none.
int termOf(const std::vector<int>& terms, std::size_t landmark)
{
  return landmark < terms.size() ? terms[landmark] : -1;
}

Pose2 differenceOf(const Pose2& plus, const Pose2& minus, double by)
{
  return {(plus.x - minus.x) / by, (plus.y - minus.y) / by, wrap(plus.phi - minus.phi) / by};
}
}  // namespace

TrajectoryModel::TrajectoryModel(const CalibrationProblem& problem, std::vector<CalibrationUnknown> unknowns)
    : problem_(problem),
      unknowns_(std::move(unknowns)),
      of_sensor_(problem.sensors),
      path_(problem.odometry, {}),
      values_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_.size())))
{
  for (std::size_t k = 0; k < unknowns_.size(); ++k)
  {
    const CalibrationParameter kind = unknowns_[k].parameter;
    SensorTerms unused, &sensor = isOfOdometry(kind) ? unused : of_sensor_[unknowns_[k].sensor];
    if (isOfLandmark(kind))
    {
      std::vector<int>& numbers = kind == CalibrationParameter::landmark_offset ? sensor.landmark_offsets
                                  : kind == CalibrationParameter::landmark_x    ? landmark_x_
                                                                                : landmark_y_;
      numbers.resize(std::max(numbers.size(), unknowns_[k].landmark + 1), -1);
      numbers[unknowns_[k].landmark] = static_cast<int>(k);
      continue;
    }
    int& number = kind == CalibrationParameter::delay               ? sensor.delay
                  : kind == CalibrationParameter::lever_arm_x       ? sensor.lever_arm_x
                  : kind == CalibrationParameter::lever_arm_y       ? sensor.lever_arm_y
                  : kind == CalibrationParameter::bearing_offset    ? sensor.bearing_offset
                  : kind == CalibrationParameter::bearing_scale     ? sensor.bearing_scale
                  : kind == CalibrationParameter::range_offset      ? sensor.range_offset
                  : kind == CalibrationParameter::range_scale       ? sensor.range_scale
                  : kind == CalibrationParameter::range_axis        ? sensor.range_axis
                  : kind == CalibrationParameter::distance_scale    ? distance_scale_
                  : kind == CalibrationParameter::distance_per_turn ? distance_per_turn_
                  : kind == CalibrationParameter::rotation_scale    ? rotation_scale_
                  : kind == CalibrationParameter::pivot_scale       ? pivot_scale_
                  : kind == CalibrationParameter::veer              ? veer_
                                                                    : drift_;
    number = static_cast<int>(k);
  }
  for (std::size_t k = 0; k < problem_.poses.size(); ++k)
    measured_.push_back(k == 0 ? MeasuredMotion{}
                               : measuredMotion(path_.between(problem_.poses[k - 1].time, problem_.poses[k].time)));
  setOdometryScatter(odometry_scatter_);
}

void TrajectoryModel::setOdometryScatter(const PerMotionNoise<double>& scatter)
{
  odometry_scatter_ = scatter;
  whitening_.clear();
  for (const TrajectoryPose& pose : problem_.poses)
  {
    Matrix3d covariance = pose.since_previous ? scattered(*pose.since_previous, scatter) : Matrix3d::Identity();
    covariance.diagonal().array() += square(kLeastLink);
    whitening_.push_back(covariance.llt().matrixL().solve(Matrix3d::Identity()));
  }
}

Matrix3d TrajectoryModel::linkCovariance(std::size_t k, MotionNoise noise) const
{
  const Matrix3d whitened = square(odometry_scatter_[noise]) * whitening_[k];
  return whitened * (*problem_.poses[k].since_previous)[noise] * whitening_[k].transpose();
}

TrajectoryModel::MeasuredMotion TrajectoryModel::measuredMotion(const OdometryMotion& motion)
{
  const PathMoments moments = momentsOf(motion);
  return {motion.increment, moments.along_arcs, moments.by_turn.z() - moments.by_arc.z()};
}

Vector2d TrajectoryModel::furtherOnArcs(std::size_t k) const
{
  return valueOf(distance_per_turn_) * measured_[k].along_arcs;
}

double TrajectoryModel::unmeasuredTurn(std::size_t k, double length) const
{
  return valueOf(pivot_scale_) * measured_[k].in_place + valueOf(veer_) * length + valueOf(drift_) * durationOf(k);
}

/// The chord of an arc turns by half of what its end turns.
Pose2 TrajectoryModel::predictOdometry(std::size_t k, const Pose2& moved) const
{
  const double turn = (moved.phi - unmeasuredTurn(k, moved.position().norm())) / (1 + valueOf(rotation_scale_));
  const Vector2d driven = rotation(0.5 * (turn - moved.phi)) * moved.position() / (1 + valueOf(distance_scale_));
  const Vector2d chord = driven - furtherOnArcs(k);
  return {chord.x(), chord.y(), turn};
}

Pose2 TrajectoryModel::backBy(double time, double late) const { return between(path_.at(time), path_.at(time - late)); }

ReadingResidual TrajectoryModel::reading(const CalibrationReading& r, const Pose2& pose) const
{
  const SensorTerms& terms = of_sensor_[r.sensor];
  const double known = r.sensor < problem_.known_delays.size() ? problem_.known_delays[r.sensor] : 0;
  const double time = problem_.poses[r.pose].time, late = valueOf(terms.delay) - known;
  const Pose2 back = late == 0 ? Pose2{} : backBy(time, late);
  const Pose2 then = compose(pose, back);
  const Pose2 T_robot_sensor{r.T_robot_sensor.x + valueOf(terms.lever_arm_x),
                             r.T_robot_sensor.y + valueOf(terms.lever_arm_y), r.T_robot_sensor.phi};
  const Vector2d offset = T_robot_sensor.position();
  const int place_x = termOf(landmark_x_, r.landmark_number), place_y = termOf(landmark_y_, r.landmark_number);
  const Vector2d landmark = r.landmark + Vector2d(valueOf(place_x), valueOf(place_y));
  ReadingResidual row{.own = {}, .shared = Eigen::RowVectorXd::Zero(values_.size())};
  JacobianRow by_then;
  double predicted = 0;
  if (r.is_range)
  {
    const double flat = predictRange(then, landmark, T_robot_sensor), slant = std::hypot(flat, r.height);
    // The depth along an axis that points elsewhere, over that along the configured one.
    const double axis = valueOf(terms.range_axis), tangent = std::tan(r.off_axis.value_or(0));
    const double depth_ratio = std::cos(axis) + tangent * std::sin(axis);
    const double scale = (1 + valueOf(terms.range_scale)) * depth_ratio;
    const int of_landmark = termOf(terms.landmark_offsets, r.landmark_number);
    predicted = scale * slant + valueOf(terms.range_offset) + valueOf(of_landmark);
    by_then = (slant > 0 ? scale * flat / slant : 0) * rangeJacobian(then, landmark, offset);
    if (terms.range_scale >= 0) row.shared[terms.range_scale] = depth_ratio * slant;
    if (terms.range_axis >= 0)
      row.shared[terms.range_axis] =
          (1 + valueOf(terms.range_scale)) * slant * (tangent * std::cos(axis) - std::sin(axis));
    if (terms.range_offset >= 0) row.shared[terms.range_offset] = 1;
    if (of_landmark >= 0) row.shared[of_landmark] = 1;
  }
  else
  {
    const double bearing = predictBearing(then, landmark, T_robot_sensor), scale = 1 + valueOf(terms.bearing_scale);
    predicted = scale * bearing + valueOf(terms.bearing_offset);
    by_then = scale * bearingJacobian(then, landmark, offset);
    if (terms.bearing_scale >= 0) row.shared[terms.bearing_scale] = bearing;
    if (terms.bearing_offset >= 0) row.shared[terms.bearing_offset] = 1;
  }
  row.residual = (r.is_range ? r.value - predicted : wrap(r.value - predicted)) / r.std;
  row.own = by_then * composeJacobianFirst(pose, back) / r.std;
  // A sensor that sits elsewhere sees what a robot sees that stands elsewhere.
  const Eigen::RowVector2d by_lever_arm = by_then.head<2>() * rotation(then.phi);
  if (terms.lever_arm_x >= 0) row.shared[terms.lever_arm_x] = by_lever_arm.x();
  if (terms.lever_arm_y >= 0) row.shared[terms.lever_arm_y] = by_lever_arm.y();
  // A landmark that stands elsewhere is seen as from a robot that stands elsewhere, the other way.
  if (place_x >= 0) row.shared[place_x] = -by_then.x();
  if (place_y >= 0) row.shared[place_y] = -by_then.y();
  if (terms.delay >= 0)
  {
    const Pose2 by_delay =
        differenceOf(backBy(time, late + kDelayChange), backBy(time, late - kDelayChange), 2 * kDelayChange);
    row.shared[terms.delay] = by_then.dot(composeJacobianSecond(pose) * by_delay.vector());
  }
  row.shared /= r.std;
  return row;
}

MotionPrediction TrajectoryModel::motion(std::size_t k) const
{
  const Pose2& logged = measured_[k].increment;
  const Vector2d driven = logged.position() + furtherOnArcs(k);
  const double distance = 1 + valueOf(distance_scale_), length = distance * driven.norm();
  const double turn = (1 + valueOf(rotation_scale_)) * logged.phi + unmeasuredTurn(k, length);
  const Matrix2d swung = distance * rotation(0.5 * (turn - logged.phi));
  const Vector2d chord = swung * driven;
  MotionPrediction motion{{chord.x(), chord.y(), turn}, {}};
  motion.shared.setZero(3, values_.size());
  const Vector2d swing = perpendicular(chord);
  const auto turned = [&](double by) { return Vector3d(0.5 * by * swing.x(), 0.5 * by * swing.y(), by); };
  if (distance_scale_ >= 0)
    motion.shared.col(distance_scale_) =
        Vector3d(chord.x(), chord.y(), 0) / distance + turned(valueOf(veer_) * length / distance);
  if (distance_per_turn_ >= 0)
  {
    const Vector2d by_arcs = measured_[k].along_arcs, further = swung * by_arcs;
    const double longer = distance * by_arcs.dot(driven.stableNormalized());
    motion.shared.col(distance_per_turn_) = Vector3d(further.x(), further.y(), 0) + turned(valueOf(veer_) * longer);
  }
  if (rotation_scale_ >= 0) motion.shared.col(rotation_scale_) = turned(logged.phi);
  if (pivot_scale_ >= 0) motion.shared.col(pivot_scale_) = turned(measured_[k].in_place);
  if (veer_ >= 0) motion.shared.col(veer_) = turned(length);
  if (drift_ >= 0) motion.shared.col(drift_) = turned(durationOf(k));
  return motion;
}

Vector3d TrajectoryModel::linkResidual(std::size_t k, const Pose2& before, const Pose2& pose) const
{
  const Pose2& logged = measured_[k].increment;
  const Pose2 predicted = predictOdometry(k, between(before, pose));
  return whitening_[k] * Vector3d(logged.x - predicted.x, logged.y - predicted.y, wrap(logged.phi - predicted.phi));
}

OdometryResidual TrajectoryModel::link(std::size_t k, const Pose2& before, const Pose2& pose) const
{
  const Pose2 moved = between(before, pose), predicted = predictOdometry(k, moved);
  const Vector2d driven = predicted.position() + furtherOnArcs(k), swing = perpendicular(driven);
  const double length = moved.position().norm(), distance = 1 + valueOf(distance_scale_),
               turn = 1 + valueOf(rotation_scale_);

  const Matrix2d R = rotation(-before.phi);
  Matrix3d moved_by_before = -Matrix3d::Identity(), moved_by_pose = Matrix3d::Identity();
  moved_by_before.topLeftCorner<2, 2>() = -R;
  moved_by_before.topRightCorner<2, 1>() = -perpendicular(moved.position());
  moved_by_pose.topLeftCorner<2, 2>() = R;

  Matrix3d predicted_by_moved = Matrix3d::Identity();
  predicted_by_moved.topLeftCorner<2, 2>() = rotation(0.5 * (predicted.phi - moved.phi)) / distance;
  predicted_by_moved(2, 2) = 1 / turn;
  if (length > 0)
    predicted_by_moved.bottomLeftCorner<1, 2>() = -valueOf(veer_) / turn * moved.position().transpose() / length;
  // The turn rotates the chord.
  predicted_by_moved.topLeftCorner<2, 2>() += 0.5 * swing * predicted_by_moved.bottomLeftCorner<1, 2>();
  predicted_by_moved.topRightCorner<2, 1>() = 0.5 * (1 / turn - 1) * swing;

  OdometryResidual row{.residual = linkResidual(k, before, pose),
                       .own = whitening_[k] * predicted_by_moved * moved_by_before,
                       .next = whitening_[k] * predicted_by_moved * moved_by_pose,
                       .shared = Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, values_.size())};
  const auto turned = [&](double by) { return Vector3d(0.5 * by * swing.x(), 0.5 * by * swing.y(), by); };
  if (distance_scale_ >= 0)
    row.shared.col(distance_scale_) = whitening_[k] * Vector3d(-driven.x() / distance, -driven.y() / distance, 0);
  if (distance_per_turn_ >= 0)
  {
    const Vector2d by_arcs = measured_[k].along_arcs;
    row.shared.col(distance_per_turn_) = whitening_[k] * Vector3d(-by_arcs.x(), -by_arcs.y(), 0);
  }
  if (rotation_scale_ >= 0) row.shared.col(rotation_scale_) = whitening_[k] * turned(-predicted.phi / turn);
  if (pivot_scale_ >= 0) row.shared.col(pivot_scale_) = whitening_[k] * turned(-measured_[k].in_place / turn);
  if (veer_ >= 0) row.shared.col(veer_) = whitening_[k] * turned(-length / turn);
  if (drift_ >= 0) row.shared.col(drift_) = whitening_[k] * turned(-durationOf(k) / turn);
  return row;
}
}  // namespace mrpt_ext
