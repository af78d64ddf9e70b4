#pragma once

#include "mrpt_ext/calibration/calibration_problem.h"

namespace mrpt_ext
{
/// A recording whose poses are those at which its readings were measured, instead of those at their stamps.
struct MeasuredRecording
{
  CalibrationProblem problem;
  std::vector<std::size_t> readings;  ///< number that each of its readings had
};

/// `delays` [s] of the sensors. Poses without readings stay. Between a stamp and the
/// measurement before it lies a motion that is known by odometry alone: a pose at the stamp errs by the noise of
/// odometry in that motion, the same noise by which odometry errs there. Compared with such poses odometry appears to
/// measure too little, by several per cent for a delay of a tenth of a second; compared with poses at the measurements
/// it does not.
[[nodiscard]] MeasuredRecording atMeasurementTimes(const CalibrationProblem& problem,
                                                   const std::vector<double>& delays);
}  // namespace mrpt_ext
