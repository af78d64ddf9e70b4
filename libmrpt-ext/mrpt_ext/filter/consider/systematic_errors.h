#pragma once

#include <Eigen/Core>
#include <vector>

#include "mrpt_ext/filter/consider/relevance.h"
#include "mrpt_ext/filter/consider/score_variance.h"
#include "mrpt_ext/filter/consider/velocity_noise.h"

namespace mrpt_ext
{
/// What systematic errors that the filter does not estimate do to its estimate. They are shared by all landmarks and do
/// not average out:
/// - of every sensor: delay, offset of bearings, offset and scale of ranges, lever arm;
/// - of odometry: veer per metre, drift per second, the place of the robot's point from the one that odometry follows.
/// Scales of odometry are left out: odometry's noise, which the innovations share, would be taken for them.
///
/// The derivatives U of the error of the estimate by these parameters follow the filter through its steps; the
/// innovations are then linear in the parameters, which are estimated by recursive least squares (the separate-bias
/// filter of Friedland, IEEE Trans. Autom. Control 14(4), 1969). Those that the innovations do not ask for are zero
/// (relevance.h), but for lever arms and delays: how well the place of a sensor on the robot and the time of its
/// readings are known is given (SensorModel), and what the innovations have not told of them, because the robot has
/// hardly turned or changed its speed, is stated. Turns tell where a sensor is from the point that odometry follows;
/// where the point whose pose is asked for is from that one is known no better than the places of the sensors. Where
/// nobody says how well these are known, those that are told tell it (place_variance.h). The estimate itself is left as
/// it is: what the parameters, and what is not known of them, do to it is added to its covariance. Correcting the
/// readings by them would help where a sensor is mounted elsewhere than stated, but errors of other kinds pass for
/// these ones, too.
class SystematicErrors
{
 public:
  /// `size`: of the filter's state. `given`: the first estimate shares no error of the readings.
  SystematicErrors(Eigen::Index size, bool given);

  /// The estimate was found from readings like those of this step, at the speed of its motion.
  void start(const LinearStep& step);
  /// Propagates through one step of the filter, and learns from its innovations.
  void update(const LinearStep& step);
  /// The estimate starts anew, without errors that came from the parameters. What is known of them is kept.
  void restart();

  /// What the errors add to the covariance of the estimate.
  [[nodiscard]] KalmanMatrix added() const;
  /// ... of that what is assumed of lever arms and delays, and no reading has shown.
  [[nodiscard]] KalmanMatrix assumed() const;

 private:
  void resize(const LinearStep& step);
  void resize(Eigen::Index parameters);
  void share(const LinearStep& step);
  /// Lever arms whose deviation nobody states, and the place of the robot's point beside them.
  [[nodiscard]] std::vector<Eigen::Index> assumedPlaces() const;
  [[nodiscard]] PriorStds prior() const;
  void predict(const LinearStep& step);
  [[nodiscard]] Eigen::MatrixXd measurementDerivatives(const LinearStep& step) const;
  void learn(const LinearStep& step, const Eigen::MatrixXd& by_parameters);
  void estimate();

  bool started_;                 // the response holds what the start owes to the readings
  Eigen::MatrixXd response_;     // U
  Eigen::MatrixXd information_;  // of the parameters
  Eigen::VectorXd weighted_;     // information times parameters
  Eigen::VectorXd by_noise_;     // ... that the noise of the velocity would have caused alone
  std::vector<SensorStds> sensor_stds_;
  RelevantParameters known_;
  Eigen::VectorXd significant_;  // share of what each adds
  Relevance relevance_;
  double place_std_ = kAssumedLeverArmStd;  // [m] deviation of the places on the robot for which none is stated
  ScoreVariance score_variance_;
  VelocityNoise velocity_;
};
}  // namespace mrpt_ext
