#pragma once

#include <map>

#include "mrpt_ext/filter/consider/innovation_correlation.h"

namespace mrpt_ext
{
/// What lasting errors of the landmarks' measurements (map, association, a sensor that errs alike for a while) do to an
/// estimate that takes them for white: the consider covariance of Schmidt ("Application of state-space methods to
/// problems in navigation", 1966). The size of the errors comes from the innovations.
class PersistentErrors
{
 public:
  /// `size`: of the filter's state.
  explicit PersistentErrors(Eigen::Index size) : size_(size) {}

  /// Propagates through one step of the filter, and learns from its innovations.
  void update(const LinearStep& step);
  /// The estimate starts anew: its error is again what the filter says. The sizes of the errors are kept.
  void restart();

  /// Variance of the lasting error of every row, as far as it is known.
  [[nodiscard]] Eigen::VectorXd lastingVariances(const LinearStep& step) const;
  /// To be added to the covariance that the filter states.
  [[nodiscard]] KalmanMatrix added() const;

 private:
  template <typename Value>
  using ForDurations = std::array<Value, kErrorDurations.size()>;

  /// Error of the estimate by lasting errors of one source, each of one stated standard deviation now.
  struct Track
  {
    double seen = 0;  // [s] last
    ForDurations<KalmanVector> response;
  };
  /// Covariance of the estimate by all errors of one kind, if each has the stated standard deviation.
  struct Effect
  {
    KalmanMatrix white;
    ForDurations<KalmanMatrix> lasting;
  };
  void predict(const LinearStep& step);
  void learn(const LinearStep& step);
  void correct(const LinearStep& step);
  /// error = A error
  void transform(const KalmanMatrix& A);

  Eigen::Index size_;
  InnovationCorrelation correlation_;
  std::map<ErrorSource, Track> tracks_;
  std::map<ErrorKind, Effect> effects_;
};
}  // namespace mrpt_ext
