#pragma once

#include "mrpt_ext/filter/consider/innovation_row.h"

namespace mrpt_ext
{
/// How much larger the noise of odometry is than stated, source by source, as the innovations show it: those of a
/// filter that trusts its odometry too much are larger than their stated covariance after the motions that err.
///
/// The error of the estimate is a sum of independent parts, one by each source of noise and one by the measurements;
/// their covariances, each for the stated variance, follow the filter through its steps. The covariance of the
/// innovations is linear in the factors of these variances, which are estimated by Fisher scoring (covariance matching:
/// Mehra, IEEE Trans. Autom. Control 17(5), 1972; variance components: Rao, J. Multivariate Anal. 1, 1971). The stated
/// noise is the prior and the least: a good drive alone does not make odometry better than stated.
class ExcessNoise
{
 public:
  /// `size`: of the filter's state.
  ExcessNoise(const MotionModel& motion, Eigen::Index size);

  /// Propagates through one step of the filter, and learns from its innovations. `lasting`: variance of the errors of
  /// each row that last: beside those the noise of odometry has to be seen.
  void update(const LinearStep& step, const Eigen::VectorXd& lasting);
  /// The estimate has been verified: what its innovations have shown since it first was is used. Those before that come
  /// from finding the pose, and tell nothing of odometry.
  void confirm()
  {
    known_ = learned_;
    confirmed_ = true;
  }
  /// The estimate starts anew, with an error that no odometry caused. What was known is kept; the innovations of an
  /// estimate that nothing confirmed may be those of a wrong pose, which look as if odometry were bad.
  void restart();

  /// Of the variances, as far as confirmed; at least 1.
  [[nodiscard]] const PerNoiseSource<double>& factors() const { return known_.factors; }
  /// Covariance of this motion beyond its stated noise.
  [[nodiscard]] Matrix3d excess(const OdometryMotion& motion) const;

 private:
  static constexpr int kParts = kNoiseSources + 1;  // the last one: measurements
  using PartMatrix = Eigen::Matrix<double, kParts, kParts>;
  using PartVector = Eigen::Matrix<double, kParts, 1>;

  /// What the innovations alone tell, and the factors that follow with the prior.
  struct Evidence
  {
    PartMatrix information = PartMatrix::Zero();
    PartVector weighted = PartVector::Zero();  // information times mean
    PerNoiseSource<double> factors;
  };

  void predict(const LinearStep& step);
  void learn(const LinearStep& step, const Eigen::VectorXd& lasting);
  void correct(const LinearStep& step);
  void solve();
  /// Rescales the evidence to the new `factors`, of which the old ones were `share`: a number of degrees of freedom
  /// tells a variance with a relative precision. Without this a few surprises, which are unlikely with the stated
  /// noise, would tell a large factor precisely, and for good: with that noise the filter follows its measurements, and
  /// innovations tell little about odometry.
  void rescale(double share, const PartVector& factors);

  MotionModel motion_;
  bool started_ = false, confirmed_ = false;
  std::array<KalmanMatrix, kParts> parts_;  // of the covariance of the estimate, for the stated variances
  Evidence learned_, known_;
};
}  // namespace mrpt_ext
