#pragma once

#include "mrpt_ext/calibration/block_tridiagonal_solver.h"
#include "mrpt_ext/calibration/trajectory_model.h"

namespace mrpt_ext
{
/// Robust adjustment of the poses and the unknowns of a recording, step by step; calibrate() runs the steps.
class TrajectoryAdjustment
{
 public:
  /// `problem` must outlive it.
  TrajectoryAdjustment(const CalibrationProblem& problem, std::vector<CalibrationUnknown> unknowns);

  /// Gauss-Newton steps until nothing moves, at most this many; a step that makes it worse is shortened. False when
  /// something is undetermined.
  [[nodiscard]] bool descend(int most_steps);
  /// Estimates the scatters from the residuals; false when something is undetermined.
  [[nodiscard]] bool estimateScatters();
  [[nodiscard]] double cost() const;
  /// Standard deviations of the unknowns: the larger of normal equations and sandwich estimator over blocks of time.
  [[nodiscard]] std::optional<Eigen::VectorXd> standardDeviations() const;

  [[nodiscard]] const TrajectoryModel& model() const { return model_; }
  [[nodiscard]] const std::vector<SensorScatter>& scatters() const { return scatters_; }
  [[nodiscard]] double odometryScatter() const { return odometry_scatter_; }
  /// Standard deviation of odometryScatter(); infinite where nothing tells it. A variance component: the derivative of
  /// its restricted likelihood is the misfit of odometry over what is expected of it, minus its redundancy (Patterson
  /// and Thompson, Biometrika 58(3), 1971). The curvature, in which the poses follow the scatter, and the disagreement
  /// of blocks of time both bound it.
  [[nodiscard]] double odometryScatterStd() const;
  [[nodiscard]] double odometryRedundancy() const { return odometry_redundancy_; }
  [[nodiscard]] int steps() const { return steps_; }
  /// Residual of each reading over its standard deviation, with the scatter found.
  [[nodiscard]] std::vector<double> misfits() const;

  /// Continues from the poses and scatters of `start`, with other values of the unknowns.
  void restart(const TrajectoryAdjustment& start, const Eigen::VectorXd& errors);
  /// Continues from the unknowns and scatters of `start`, which has other poses.
  void continueFrom(const TrajectoryAdjustment& start);

 private:
  [[nodiscard]] double scatterOf(const CalibrationReading& reading) const;
  [[nodiscard]] double assumedScatterOf(const CalibrationReading& reading) const;
  [[nodiscard]] double linkScale() const { return 1 / odometry_scatter_; }
  [[nodiscard]] PoseChainSystem linearized() const;
  /// Of each link: squared residual, in declared standard deviations, and redundancy.
  [[nodiscard]] Eigen::Matrix2Xd linkFits(const ChainSolution& solution) const;
  using LinkFit = Eigen::Vector2d;  // their sums
  /// By block of time: derivative of the logarithm of the restricted likelihood by that of the scatter.
  [[nodiscard]] std::optional<Eigen::VectorXd> scatterScores(double scatter) const;
  void move(const ChainSolution& solution, double share, const std::vector<Pose2>& from, const Eigen::VectorXd& errors);
  [[nodiscard]] Eigen::MatrixXd scoresByBlock(const ChainSolution& solution, double& curvature) const;

  const CalibrationProblem& problem_;
  TrajectoryModel model_;
  std::vector<Pose2> poses_;
  std::vector<SensorScatter> scatters_;
  double odometry_scatter_ = 1, odometry_redundancy_ = 0;
  int steps_ = 0;
};
}  // namespace mrpt_ext
