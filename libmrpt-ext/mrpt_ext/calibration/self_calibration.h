#pragma once

#include <Eigen/Core>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// What the readings of one sensor scatter like.
struct SensorScatter
{
  double bearing = 1, range = 1;  ///< over the declared standard deviation
  std::size_t bearings = 0, ranges = 0;
};

/// An error as the recording tells it.
struct EstimatedError
{
  ErrorTerm term;
  bool observable = false;  ///< false: the recording does not determine it; it was held at 0 for all others
  double value = 0;         ///< in the unit of its kind; 0 when not told
  double std = 0;           ///< likewise; when not told, what a free one would have had, or 0
};

struct RecordingErrors
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<EstimatedError> errors;  ///< in the order of the terms
  std::vector<Pose2> poses;
  std::vector<SensorScatter> scatter;  ///< by sensor
  std::vector<double> misfits;         ///< by reading: residual over its deviation, both as the fit has them; signed
  double way_scatter = 1;              ///< of odometry, over what was declared
  int iterations = 0;
};

/// Systematic errors of a recording from the recording and the map alone: all poses and all errors are adjusted
/// together, readings against predictions, the way between poses against odometry (Gauss-Newton, PoseChainSystem).
/// Outliers do not count (Geman-McClure loss of four deviations for readings; of odometry only what is beyond twenty).
/// Scatters of readings (median) and of odometry (its redundancy) are estimated beside it, so that declared deviations
/// of odometry need only be right to a factor of ten; readings are never believed more than declared. Delays are also
/// tried from starts of up to 1 s either way.
///
/// Standard deviations are the larger of two: those of the normal equations with the scatters found, and those that
/// the parts of the recording show by disagreeing with each other (sandwich over up to thirty blocks of time: errors
/// that last are counted as what they are). An error whose deviation exceeds what makes it of use (delay 0.1 s, bearing
/// 3 deg, range a twentieth of the typical range, range scale 0.05, odometry scales 0.1, veer 0.05 rad/m) is not told;
/// the worst one is held at 0 and the others are estimated again. A robot that does not move by more than odometry errs
/// tells no delays and no errors of odometry.
/// Status: `too_few` below 20 readings or 3 per error, `degenerate` when poses stay undetermined, `bad_input`.
[[nodiscard]] RecordingErrors calibrate(const CalibrationProblem& way, const std::vector<ErrorTerm>& terms);
}  // namespace mrpt_ext
