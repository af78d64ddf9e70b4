#pragma once

#include <Eigen/Core>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A parameter as the recording determines it.
struct ParameterEstimate
{
  CalibrationUnknown unknown;
  bool observable =
      false;         ///< false: the recording does not determine it; to the others it is as uncertain as `std` says
  double value = 0;  ///< in the unit of the parameter; 0 when not observable
  double std = 0;    ///< likewise; 0 where the robot does not move by more than odometry errs
};

struct CalibrationResult
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<ParameterEstimate> errors;  ///< in the order of the unknowns
  Eigen::MatrixXd covariance;             ///< of the errors by the normal equations; zero where one is not observable
  std::vector<SensorScatter> scatter;     ///< by sensor
  std::vector<double> misfits;  ///< by reading: signed residual over its standard deviation, with the scatter found
  PerMotionNoise<double> odometry_scatter{1, 1};      ///< over the declared standard deviations
  PerMotionNoise<double> odometry_scatter_std{0, 0};  ///< of those; infinite: the recording does not tell it
  /// Number of its residuals less what the adjustment took up.
  PerMotionNoise<double> odometry_redundancy{0, 0};
  int iterations = 0;
};

/// Self-calibration: systematic errors of a recording from the recording and the map alone. All poses and all unknowns
/// are adjusted together: readings against their predictions, the motion between poses against odometry (Gauss-Newton,
/// PoseChainSystem). Outliers hardly count (robust_loss.h: at last a reading counts by its probability of
/// being none; odometry up to 12.5 standard deviations). The poses lie where the readings were measured, not at their
/// stamps (measurement_times.h). The scatter of readings (median) and of odometry (its redundancy) is estimated too, so
/// that the declared standard deviations of odometry need only be right to a factor of ten; those of readings are a
/// lower bound. Delays are also started from up to 1 s early and late.
///
/// The standard deviation of a parameter is the larger of two: that of the normal equations with the scatters found,
/// and that by which separate parts of the recording disagree (sandwich estimator over up to thirty blocks of time,
/// which counts correlated errors for what they are). Offsets of single landmarks, and their places in the map, are
/// random with a deviation that is estimated too (restricted maximum likelihood): what all landmarks share is told as
/// well as they agree. A parameter is observable when its standard deviation is small enough to be of use (delay 0.1 s,
/// bearing offset 3 deg, range offset and place of a landmark a twentieth of the typical range, range scale 0.05,
/// odometry scales 0.1, veer 0.05 rad/m, drift 1 deg/s, bearing scale 0.025, axis of depths 1.4 deg, lever arms half of
/// what was not known; parameter_limits.h). One that is not stays in the adjustment with its prior. A robot that does
/// not move by more than the error of its odometry makes no delay and no parameter of odometry observable. Status:
/// `too_few` below 20 readings or 3 per unknown, `degenerate` when poses stay undetermined, `bad_input`.
[[nodiscard]] CalibrationResult calibrate(const CalibrationProblem& problem,
                                          const std::vector<CalibrationUnknown>& unknowns);
}  // namespace mrpt_ext
