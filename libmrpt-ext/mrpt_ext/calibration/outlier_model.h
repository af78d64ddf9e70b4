#pragma once

#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"

namespace mrpt_ext
{
/// Longest range of each sensor, at least 1 [m]: its outliers are as likely anywhere up to there.
[[nodiscard]] std::vector<double> longestRanges(const CalibrationProblem& problem);

/// How a reading counts: its loss, the weight in the normal equations (d loss / d e2), and the second derivative of
/// half the loss.
struct ReadingLoss
{
  double loss = 0, weight = 1, curvature = 1;
};

/// The loss of readings. At first that of Geman and McClure (robust_loss.h); once outliers are told, minus twice the
/// logarithm of a mixture: a reading is Gaussian, or an outlier anywhere between none and the longest range of its
/// sensor, or around the circle. The shares of outliers are those that the readings show (expectation maximization:
/// Dempster, Laird, Rubin, J. R. Statist. Soc. B 39, 1977).
class OutlierModel
{
 public:
  void tell(const CalibrationProblem& problem);
  [[nodiscard]] bool told() const { return !by_sensor_.empty(); }
  /// At this many squared deviations; `scatter`: these over the declared one.
  [[nodiscard]] ReadingLoss lossOf(const CalibrationReading& reading, double e2, double scatter) const;
  /// Shares from the weights of all readings.
  void estimateShares(const CalibrationProblem& problem, const std::vector<double>& weights);

 private:
  struct Kind
  {
    double share = 0.05, span = kTwoPi;  // span: [m] or [rad]
  };
  struct Sensor
  {
    Kind bearings, ranges;
  };
  std::vector<Sensor> by_sensor_;
};
}  // namespace mrpt_ext
