#pragma once

#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"

namespace mrpt_ext
{
/// What is assumed of a systematic error: Gaussian, then a random walk. Deviation 0: known.
struct AssumedError
{
  CalibrationUnknown unknown;
  double mean = 0, std = 0, std_per_sqrt_s = 0;  ///< in the unit of the parameter
};

/// What is assumed of the readings of one sensor.
struct AssumedNoise
{
  double bearing = 1, range = 1;  ///< standard deviation over the declared one
  double outliers = 0.05;         ///< share, in [0, 1)
};

/// A model of a recording, to be compared with others by what it predicts.
struct RecordingModel
{
  std::vector<AssumedError> errors;
  std::vector<AssumedNoise> sensors;      ///< by sensor
  PerMotionNoise<double> odometry{1, 1};  ///< standard deviations of odometry over the declared ones
};

/// Logarithm of the density [1/rad] or [1/m] of every reading, given all readings before it: the innovations form of
/// the likelihood (BS 5.4; Schweppe 1965), by an extended Kalman filter of the pose and the uncertain errors. A reading
/// is either Gaussian or an outlier, uniform over the circle or over the ranges of its sensor; an outlier does not
/// update. The filter starts at the first guess of pose `first`, of every pose after a break of the chain, and when
/// outliers were five in a row, more where more are assumed: it has lost the robot. Readings before it count 0. A
/// proper score: neither wrong errors nor wrong deviations pay.
[[nodiscard]] std::vector<double> predictiveLogDensities(const CalibrationProblem& problem, const RecordingModel& model,
                                                         std::size_t first = 0);

/// How much better one model predicts than another.
struct PredictiveGain
{
  double gain = 0;  ///< difference of the log likelihoods
  double std = 0;   ///< of the gain, from blocks of time; infinite with too few of them
};

/// From pose `first` on. `better` and `worse`: log densities by reading.
[[nodiscard]] PredictiveGain predictiveGain(const CalibrationProblem& problem, std::size_t first,
                                            const std::vector<double>& better, const std::vector<double>& worse);
}  // namespace mrpt_ext
