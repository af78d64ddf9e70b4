#pragma once

#include <array>
#include <deque>
#include <map>

#include "mrpt_ext/filter/consider/innovation_row.h"

namespace mrpt_ext
{
/// Lasting errors of a measurement decay with one of these time constants [s] (first-order Gauss-Markov processes):
/// shorter than a second, some seconds, and longer than a landmark stays in view (an error of the map or calibration).
inline constexpr std::array<double, 3> kErrorDurations = {0.5, 5, 100};

/// One value per time constant.
using PerDuration = std::array<double, kErrorDurations.size()>;

/// Splits the errors of measurements into white and lasting ones by the autocorrelation of the innovations (BS 5.4):
/// those of a filter whose measurements have white errors are uncorrelated in time.
///
/// The covariance of two innovations of one landmark is the variance of its lasting error times how much of that error
/// the innovations still show: the filter has followed it in part. Variances are pooled over the landmarks of a sensor,
/// relative to the stated variance. Before anything was seen a tenth of it is taken to last (real sensors are like
/// that), which counts like a few hundred pairs of innovations.
class InnovationCorrelation
{
 public:
  /// Takes one innovation. `visible`: derivative of the innovation by the lasting error of its source.
  void add(double time, const InnovationRow& row, const PerDuration& visible);

  /// Drops what no later innovation can be compared with.
  void forget(double time);

  /// Variance of the lasting errors of this kind of measurement, relative to the stated variance of a measurement.
  [[nodiscard]] PerDuration lastingShares(const ErrorKind& kind) const;

 private:
  struct Past
  {
    double time = 0, innovation = 0;  // relative to the stated standard deviation
    double variance = 1;              // of that
    PerDuration visible;
  };
  /// Least squares over pairs of innovations: product = visible parts times the variance that is asked for.
  struct Sums
  {
    double products = 0, visible = 0, variance = 0;  // variance: of the products, if the errors are white
  };
  std::map<ErrorSource, std::deque<Past>> past_;
  std::map<ErrorKind, std::array<Sums, kErrorDurations.size()>> sums_;
};
}  // namespace mrpt_ext
