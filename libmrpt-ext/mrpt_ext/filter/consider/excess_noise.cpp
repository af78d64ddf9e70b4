#include "mrpt_ext/filter/consider/excess_noise.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kNoiseMemory = 300;   // [s] after which the floor may be another one
constexpr double kStatedWorth = 60;    // degrees of freedom that the stated noise counts as beside what is in common
constexpr double kInCommon = 1;        // standard deviation of the factor that all sources share, in units of it
constexpr double kMostNoise = 100;     // times the stated variance
constexpr double kSurpriseLimit = 25;  // times the expected square that one step counts as at most
}  // namespace

ExcessNoise::ExcessNoise(const MotionModel& motion, Eigen::Index size) : motion_(motion)
{
  parts_.fill(KalmanMatrix::Zero(size, size));
  learned_.factors.fill(1);
  known_ = learned_;
}

void ExcessNoise::restart()
{
  learned_ = known_;
  started_ = confirmed_ = false;
}

Matrix3d ExcessNoise::excess(const OdometryMotion& motion) const
{
  const PerNoiseSource<Matrix3d> stated = covarianceBySource(motion_, motion);
  Matrix3d sum = Matrix3d::Zero();
  if (motion_.type == MotionType::random_walk) return sum;
  for (std::size_t i = 0; i < kNoiseSources; ++i) sum += (known_.factors[i] - 1) * stated[i];
  return sum;
}

void ExcessNoise::update(const LinearStep& step, const Eigen::VectorXd& lasting)
{
  if (!started_)
  {
    for (KalmanMatrix& part : parts_) part.setZero();
    parts_.back() = step.before.covariance;
    started_ = true;
  }
  predict(step);
  if (confirmed_ && !step.rows.empty()) learn(step, lasting);
  correct(step);
}

void ExcessNoise::predict(const LinearStep& step)
{
  const KalmanMatrix& F = step.motion_jacobian;
  const Matrix3d to_world = composeJacobianSecond(step.before.pose());
  const PerNoiseSource<Matrix3d> stated = covarianceBySource(motion_, step.motion);
  for (std::size_t i = 0; i < parts_.size(); ++i)
  {
    parts_[i] = (F * parts_[i] * F.transpose()).eval();
    if (i < stated.size()) parts_[i].topLeftCorner<3, 3>() += to_world * stated[i] * to_world.transpose();
  }
}

void ExcessNoise::learn(const LinearStep& step, const Eigen::VectorXd& lasting)
{
  // The measurements as one of the state: with S = H P H^T + R, M = H^T S^-1 H, y = H^T S^-1 innovation.
  const Eigen::Index size = step.predicted.mean.size();
  KalmanMatrix information = KalmanMatrix::Zero(size, size);
  KalmanVector gradient = KalmanVector::Zero(size);
  double squared = 0;
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const KalmanRow& z = step.rows[i].row;
    const double variance = z.variance + lasting[static_cast<Eigen::Index>(i)];
    information += z.jacobian.transpose() * z.jacobian / variance;
    gradient += z.jacobian.transpose() * (z.residual / variance);
    squared += square(z.residual) / variance;
  }
  const KalmanMatrix I = KalmanMatrix::Identity(size, size);
  // As if the filter had used the factors found so far: with smaller ones a few surprises would seem to tell a large
  // factor precisely.
  KalmanMatrix P = step.predicted.covariance;
  PartVector factors = PartVector::Ones();
  for (std::size_t i = 0; i < kNoiseSources; ++i)
  {
    factors[static_cast<Eigen::Index>(i)] = std::max(learned_.factors[i], known_.factors[i]);
    P += (factors[static_cast<Eigen::Index>(i)] - known_.factors[i]) * parts_[i];
  }
  const KalmanMatrix posterior = KalmanMatrix(I + P * information).partialPivLu().solve(P);
  const KalmanMatrix explained = information * posterior;
  const KalmanMatrix rest = I - explained;
  const KalmanMatrix M = rest * information, by_measurement = M * rest.transpose();
  const KalmanVector y = rest * gradient, correction = posterior * gradient;

  const auto count = static_cast<double>(step.rows.size());
  constexpr int kMeasured = kParts - 1;
  std::array<KalmanMatrix, kParts> seen;
  PartVector shown, expected;
  for (int i = 0; i < kParts; ++i)
  {
    const KalmanMatrix& part = parts_[static_cast<std::size_t>(i)];
    seen[static_cast<std::size_t>(i)] = M * part;
    shown[i] = y.dot(part * y);
    expected[i] = seen[static_cast<std::size_t>(i)].trace();
  }
  shown[kMeasured] += squared - 2 * gradient.dot(correction) + correction.dot(information * correction);
  expected[kMeasured] += count - explained.trace();
  PartMatrix more;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j < kParts; ++j)
      more(i, j) =
          (seen[static_cast<std::size_t>(i)].cwiseProduct(seen[static_cast<std::size_t>(j)].transpose())).sum();
  for (int i = 0; i < kParts; ++i)
  {
    const double shared = by_measurement.cwiseProduct(parts_[static_cast<std::size_t>(i)]).sum();
    more(i, kMeasured) += shared;
    more(kMeasured, i) += shared;
  }
  more(kMeasured, kMeasured) += count - 2 * explained.trace() + explained.cwiseProduct(explained.transpose()).sum();

  shown = shown.cwiseMin(kSurpriseLimit * expected);
  if (!more.allFinite() || !shown.allFinite()) return;
  const double kept = std::exp(-std::max(0.0, step.motion.duration) / kNoiseMemory);
  learned_.information = kept * learned_.information + more;
  learned_.weighted = kept * learned_.weighted + shown - expected + more * factors;
  solve();
}

void ExcessNoise::solve()
{
  // Odometry that is worse than stated in one kind of motion mostly is in the others, too: a minute tells that much of
  // all sources together, and next to nothing of each by itself.
  PartVector size = PartVector::Ones(), shared = PartVector::Zero();
  for (std::size_t i = 0; i < kNoiseSources; ++i)
    size[static_cast<Eigen::Index>(i)] = shared[static_cast<Eigen::Index>(i)] = learned_.factors[i];
  PartMatrix of_prior = square(kInCommon) * shared * shared.transpose();
  of_prior.diagonal() += 2 / kStatedWorth * size.cwiseAbs2();
  const PartMatrix prior = 2 * of_prior.llt().solve(PartMatrix::Identity());
  const PartMatrix covariance = 2 * PartMatrix(learned_.information + prior).llt().solve(PartMatrix::Identity());
  const PartVector factors = 0.5 * covariance * (learned_.weighted + prior * PartVector::Ones());
  if (!factors.allFinite()) return;
  double before = 0, after = 0;  // typical factor, by what each source has to do with the innovations
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(kNoiseSources); ++i)
  {
    const double seen = std::sqrt(std::max(0.0, learned_.information(i, i)));
    double& factor = learned_.factors[static_cast<std::size_t>(i)];
    before += seen * factor;
    factor = std::clamp(factors[i], 1.0, kMostNoise);
    after += seen * factor;
  }
  if (before > 0) rescale(before / after, factors);
}

void ExcessNoise::rescale(double share, const PartVector& factors)
{
  PartVector shares = PartVector::Constant(share);
  shares[kParts - 1] = 1;
  const PartVector gradient = learned_.weighted - learned_.information * factors;
  learned_.information = (shares.asDiagonal() * learned_.information * shares.asDiagonal()).eval();
  learned_.weighted = learned_.information * factors + shares.cwiseAbs2().cwiseProduct(gradient);
}

void ExcessNoise::correct(const LinearStep& step)
{
  const KalmanMatrix& A = step.remaining;
  for (KalmanMatrix& part : parts_) part = (A * part * A.transpose()).eval();
  for (std::size_t i = 0; i < step.rows.size(); ++i)
    parts_.back() += step.rows[i].row.variance * step.gains[i] * step.gains[i].transpose();
}
}  // namespace mrpt_ext
