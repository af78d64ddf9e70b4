#include <Eigen/Cholesky>

#include "mrpt_ext/filter/kalman/facing_update.h"
#include "mrpt_ext/filter/kalman/kalman_association.h"
#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr int kMaxIterations = 10;
constexpr int kMaxHalvings = 6;
constexpr double kConverged = 1e-4;  // share of the posterior's standard deviations

KalmanVector difference(const KalmanVector& to, const KalmanVector& from)
{
  KalmanVector step = to - from;
  step[2] = wrap(step[2]);
  return step;
}

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
    const KalmanVector from_prior = difference(mean, prior_.mean);
    double sum = from_prior.dot(prior_factor_.solve(from_prior));
    for (const KalmanRow& row : rowsAt(mean)) sum += row.residual * row.residual / row.variance;
    return sum;
  }

  /// The prior updated with the rows linearised at `mean`: its mean is where Gauss-Newton goes next.
  [[nodiscard]] KalmanState linearPosterior(const KalmanVector& mean) const
  {
    std::vector<KalmanRow> rows = rowsAt(mean);
    const KalmanVector from_prior = difference(mean, prior_.mean);
    for (KalmanRow& row : rows) row.residual += row.jacobian.dot(from_prior);
    KalmanState posterior = prior_;
    applyRows(rows, posterior);
    return posterior;
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
  KalmanState posterior = measurements.linearPosterior(mean);
  for (int i = 0; i < kMaxIterations; ++i)
  {
    const KalmanVector full = difference(posterior.mean, mean);
    double share = 1, lower = measurements.cost(moved(mean, full));
    for (int k = 0; k < kMaxHalvings && !(lower <= cost); ++k)
    {
      share /= 2;
      lower = measurements.cost(moved(mean, share * full));
    }
    if (!(lower <= cost)) break;  // the maximum to within rounding
    mean = moved(mean, share * full);
    cost = lower;
    posterior = measurements.linearPosterior(mean);
    const KalmanVector deviations = posterior.covariance.diagonal().cwiseSqrt();
    if ((full.cwiseAbs().array() <= kConverged * deviations.array()).all()) break;
  }
  update.state = {mean, posterior.covariance};
  return update;
}
}  // namespace mrpt_ext
