#include <Eigen/Cholesky>

#include "mrpt_ext/filter/kalman/facing_update.h"
#include "mrpt_ext/filter/kalman/kalman_association.h"
#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/filter/kalman/rigid_step.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr int kMaxIterations = 10;
constexpr int kMaxHalvings = 6;
constexpr double kConverged = 1e-4;  // share of the posterior's standard deviations

/// The cost function.
class UsedMeasurements
{
 public:
  UsedMeasurements(const KalmanState& prior, const KalmanUpdate& update, const Frame& frame, const LandmarkTable& map,
                   const BiasModel& biases)
      : prior_(prior),
        prior_factor_(prior.covariance),
        update_(update),
        frame_(frame),
        readings_(scoredReadings(frame)),
        map_(map),
        biases_(biases)
  {
  }

  /// All rows that were used, linearised at `mean`.
  [[nodiscard]] std::vector<KalmanRow> rowsAt(const KalmanVector& mean) const
  {
    std::vector<KalmanRow> rows;
    for (const DetectionUse& use : update_.detections)
    {
      if (!use.landmark) continue;
      const Reading& reading = readings_[use.reading];
      const DetectionRows found =
          linearise(reading.detections[use.detection], reading, map_[*use.landmark], mean, biases_);
      rows.insert(rows.end(), rowsOf(found).begin(), rowsOf(found).end());
      if (use.attitude)
        rows.push_back(lineariseFacing(reading.detections[use.detection], *use.attitude, reading, map_, mean, biases_));
    }
    if (update_.compass_used)
      rows.push_back(lineariseHeading(frame_.compass->heading, frame_.compass->std_heading, mean));
    return rows;
  }

  /// Twice the negative logarithm of the posterior density, up to a constant.
  [[nodiscard]] double cost(const KalmanVector& mean) const
  {
    const KalmanVector from_prior = rigidStep(prior_.mean, mean);
    double sum = from_prior.dot(prior_factor_.solve(from_prior));
    for (const KalmanRow& row : rowsAt(mean)) sum += row.residual * row.residual / row.variance;
    return sum;
  }

  /// The step from `mean` where Gauss-Newton goes next.
  [[nodiscard]] StepPosterior gaussNewton(const KalmanVector& mean) const
  {
    const KalmanVector from_prior = rigidStep(prior_.mean, mean);
    const KalmanMatrix J = rigidStepJacobian(from_prior);
    std::vector<KalmanRow> rows = rowsAt(mean);
    for (KalmanRow& row : rows)
    {
      row.jacobian = (row.jacobian * J).eval();
      row.residual += row.jacobian.dot(from_prior);
    }
    const StepPosterior posterior = posteriorStep(rows, prior_.covariance);
    return {J * (posterior.step - from_prior), posterior.covariance};
  }

  /// The prior at `mean` and what the rows tell there.
  [[nodiscard]] KalmanMatrix covarianceAt(const KalmanVector& mean) const
  {
    const KalmanMatrix prior = transported(prior_.covariance, rigidStep(prior_.mean, mean));
    return posteriorStep(rowsAt(mean), prior).covariance;
  }

 private:
  const KalmanState& prior_;
  Eigen::LLT<KalmanMatrix> prior_factor_;
  const KalmanUpdate& update_;
  const Frame& frame_;
  std::vector<Reading> readings_;
  const LandmarkTable& map_;
  const BiasModel& biases_;
};
}  // namespace

KalmanUpdate updateIterated(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                            const BiasModel& biases)
{
  KalmanUpdate update = updateExtended(prior, frame, map, biases);
  if (update.degrees_of_freedom == 0) return update;
  const UsedMeasurements measurements(prior, update, frame, map, biases);
  KalmanVector mean = update.state.mean;
  double cost = measurements.cost(mean);
  StepPosterior posterior = measurements.gaussNewton(mean);
  for (int i = 0; i < kMaxIterations; ++i)
  {
    const KalmanVector full = posterior.step;
    double share = 1, lower = measurements.cost(movedRigidly(mean, full));
    for (int k = 0; k < kMaxHalvings && !(lower <= cost); ++k)
    {
      share /= 2;
      lower = measurements.cost(movedRigidly(mean, share * full));
    }
    if (!(lower <= cost)) break;  // the maximum to within rounding
    mean = movedRigidly(mean, share * full);
    cost = lower;
    posterior = measurements.gaussNewton(mean);
    const KalmanVector deviations = posterior.covariance.diagonal().cwiseSqrt();
    if ((full.cwiseAbs().array() <= kConverged * deviations.array()).all()) break;
  }
  update.state = {mean, measurements.covarianceAt(mean)};
  return update;
}
}  // namespace mrpt_ext
