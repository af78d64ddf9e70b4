#include "mrpt_ext/filter/kalman/kalman_innovation.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/kalman/rigid_step.h"
#include "mrpt_ext/geometry/log_probability.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinVariance = 1e-18;

double varianceOf(const KalmanRow& row, const KalmanMatrix& covariance)
{
  return std::max(row.jacobian.dot(covariance * row.jacobian.transpose()) + row.variance, kMinVariance);
}

Innovation single(double residual, double variance)
{
  return {logNormal(residual, variance), residual * residual / variance};
}
}  // namespace

Innovation innovationOf(std::span<const KalmanRow> rows, const KalmanMatrix& covariance)
{
  const double first = varianceOf(rows[0], covariance);
  if (rows.size() == 1) return single(rows[0].residual, first);
  // The second given the first: N(a) N(b | a).
  const double cross = rows[0].jacobian.dot(covariance * rows[1].jacobian.transpose());
  const double second = varianceOf(rows[1], covariance) - cross * cross / first;
  const Innovation a = single(rows[0].residual, first);
  const Innovation b = single(rows[1].residual - cross / first * rows[0].residual, std::max(second, rows[1].variance));
  return {a.log_density + b.log_density, a.nis + b.nis};
}

StepPosterior posteriorStep(std::span<const KalmanRow> rows, const KalmanMatrix& prior)
{
  StepPosterior posterior{KalmanVector::Zero(prior.rows()), prior};
  for (const KalmanRow& row : rows)
  {
    const KalmanVector PH = posterior.covariance * row.jacobian.transpose();
    const KalmanVector K = PH / varianceOf(row, posterior.covariance);
    posterior.step += K * (row.residual - row.jacobian.dot(posterior.step));
    KalmanMatrix A = KalmanMatrix::Identity(prior.rows(), prior.rows());
    A.noalias() -= K * row.jacobian;
    const KalmanMatrix joseph = A * posterior.covariance * A.transpose() + row.variance * K * K.transpose();
    posterior.covariance = 0.5 * (joseph + joseph.transpose());
  }
  return posterior;
}

void applyRows(std::span<const KalmanRow> rows, KalmanState& state)
{
  const StepPosterior posterior = posteriorStep(rows, state.covariance);
  state = {movedRigidly(state.mean, posterior.step), transported(posterior.covariance, posterior.step)};
}
}  // namespace mrpt_ext
