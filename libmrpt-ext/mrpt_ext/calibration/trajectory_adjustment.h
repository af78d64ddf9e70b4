#pragma once

#include "mrpt_ext/calibration/block_tridiagonal_solver.h"
#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/calibration/trajectory_model.h"

namespace mrpt_ext
{
/// Robust adjustment of the poses and errors of a recording, step by step; see self_calibration.h.
class TrajectoryAdjustment
{
 public:
  /// `way` must outlive it.
  TrajectoryAdjustment(const CalibrationProblem& way, std::vector<ErrorTerm> terms);

  /// Gauss-Newton steps until nothing moves, at most this many; a step that makes it worse is shortened. False when
  /// something is undetermined.
  [[nodiscard]] bool descend(int most_steps);
  /// The scatters as the residuals have them.
  [[nodiscard]] bool estimateScatters();
  [[nodiscard]] double cost() const;
  /// Deviations of the errors, see self_calibration.h.
  [[nodiscard]] std::optional<Eigen::VectorXd> deviations() const;

  [[nodiscard]] const TrajectoryModel& model() const { return model_; }
  [[nodiscard]] const std::vector<Pose2>& poses() const { return poses_; }
  [[nodiscard]] const std::vector<SensorScatter>& scatters() const { return scatters_; }
  [[nodiscard]] double wayScatter() const { return way_scatter_; }
  [[nodiscard]] int steps() const { return steps_; }
  /// Residual of each reading over its deviation.
  [[nodiscard]] std::vector<double> misfits() const;

  /// Goes on from other errors, and from the poses of `start`.
  void restart(const TrajectoryAdjustment& start, const Eigen::VectorXd& errors);

 private:
  [[nodiscard]] double scatterOf(const CalibrationReading& reading) const;
  [[nodiscard]] double believedScatterOf(const CalibrationReading& reading) const;
  [[nodiscard]] double linkScale() const { return 1 / way_scatter_; }
  [[nodiscard]] PoseChainSystem linearised() const;
  void move(const ChainSolution& solution, double share, const std::vector<Pose2>& from, const Eigen::VectorXd& errors);
  [[nodiscard]] Eigen::MatrixXd scoresByBlock(const ChainSolution& solution, double& curvature) const;

  const CalibrationProblem& way_;
  TrajectoryModel model_;
  std::vector<Pose2> poses_;
  std::vector<SensorScatter> scatters_;
  double way_scatter_ = 1;
  int steps_ = 0;
};
}  // namespace mrpt_ext
