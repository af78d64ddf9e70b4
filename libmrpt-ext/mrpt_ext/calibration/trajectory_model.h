#pragma once

#include <Eigen/Core>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
/// A reading against its prediction, in declared standard deviations.
struct ReadingResidual
{
  double residual = 0;        ///< measured minus predicted
  JacobianRow own;            ///< of the prediction, by its pose
  Eigen::RowVectorXd shared;  ///< by the errors
};

/// The motion between a pose and the next against odometry, in standard deviations: the declared times the scatter.
struct OdometryResidual
{
  Vector3d residual{0, 0, 0};  ///< odometry minus predicted
  Matrix3d own, next;          ///< of the prediction, by the two poses
  Eigen::Matrix<double, 3, Eigen::Dynamic> shared;
};

/// The motion between two poses, as odometry and the errors say, with its derivative by the shared unknowns.
struct MotionPrediction
{
  Pose2 moved;  ///< the later pose in the frame of the earlier one
  Eigen::Matrix<double, 3, Eigen::Dynamic> shared;
};

/// Measurement model of a recording, given its poses and its systematic errors. Odometry is a measurement with noise:
/// it is predicted from the poses, never scaled to fit them, or its noise would count as distance. The derivative by a
/// delay is a finite difference (odometry is a polygon).
class TrajectoryModel
{
 public:
  /// `problem` must outlive the model.
  TrajectoryModel(const CalibrationProblem& problem, std::vector<CalibrationUnknown> unknowns);

  /// `values` in the order of the unknowns.
  void setErrors(const Eigen::VectorXd& values) { values_ = values; }
  [[nodiscard]] const Eigen::VectorXd& errors() const { return values_; }
  [[nodiscard]] const std::vector<CalibrationUnknown>& unknowns() const { return unknowns_; }
  /// Standard deviations of odometry over the declared ones.
  void setOdometryScatter(const PerMotionNoise<double>& scatter);
  [[nodiscard]] const PerMotionNoise<double>& odometryScatter() const { return odometry_scatter_; }

  [[nodiscard]] ReadingResidual reading(const CalibrationReading& reading, const Pose2& pose) const;
  /// Between pose `k - 1` and pose `k`, which must be tied.
  [[nodiscard]] OdometryResidual link(std::size_t k, const Pose2& before, const Pose2& pose) const;
  /// The motion from pose `k - 1` to pose `k`: the inverse of what link() predicts.
  [[nodiscard]] MotionPrediction motion(std::size_t k) const;
  /// Covariance of the residual of link() by one noise alone; together they are the unit matrix.
  [[nodiscard]] Matrix3d linkCovariance(std::size_t k, MotionNoise noise) const;
  /// The residual of link() alone.
  [[nodiscard]] Vector3d linkResidual(std::size_t k, const Pose2& before, const Pose2& pose) const;

 private:
  /// Numbers of the unknowns of a sensor, -1: none.
  struct SensorTerms
  {
    int delay = -1, lever_arm_x = -1, lever_arm_y = -1, bearing_offset = -1, bearing_scale = -1, range_offset = -1,
        range_scale = -1, range_axis = -1;
    std::vector<int> landmark_offsets;  // by landmark, up to the last that has one
  };
  /// By odometry, since the pose before.
  struct MeasuredMotion
  {
    Pose2 increment;
    Vector2d along_arcs{0, 0};  // [rad] see PathMoments
    double in_place = 0;        // [rad] of its turn, what was turned in place
  };
  [[nodiscard]] static MeasuredMotion measuredMotion(const OdometryMotion& motion);
  [[nodiscard]] double valueOf(int term) const { return term < 0 ? 0 : values_[term]; }
  /// How much further than measured the robot drives on arcs between pose `k - 1` and pose `k`, in axes of the former.
  [[nodiscard]] Vector2d furtherOnArcs(std::size_t k) const;
  /// Odometry that a motion between pose `k - 1` and pose `k` should give.
  [[nodiscard]] Pose2 predictOdometry(std::size_t k, const Pose2& moved) const;
  /// [rad] Turn between pose `k - 1` and pose `k` beside the scaled one, over `length` [m].
  [[nodiscard]] double unmeasuredTurn(std::size_t k, double length) const;
  [[nodiscard]] double durationOf(std::size_t k) const { return problem_.poses[k].time - problem_.poses[k - 1].time; }
  /// Motion by odometry from the stamp to `late` [s] before it.
  [[nodiscard]] Pose2 backBy(double time, double late) const;

  const CalibrationProblem& problem_;
  std::vector<CalibrationUnknown> unknowns_;
  std::vector<SensorTerms> of_sensor_;
  std::vector<int> landmark_x_, landmark_y_;  // by landmark, up to the last that has one
  int distance_scale_ = -1, distance_per_turn_ = -1, rotation_scale_ = -1, pivot_scale_ = -1, veer_ = -1,
      drift_ = -1;  // numbers of their unknowns
  OdometryPath path_;
  std::vector<MeasuredMotion> measured_;
  PerMotionNoise<double> odometry_scatter_{1, 1};
  std::vector<Matrix3d> whitening_;  // of each link
  Eigen::VectorXd values_;
};
}  // namespace mrpt_ext
