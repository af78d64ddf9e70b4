#include "mrpt_ext/filter/kalman/measurement_linearization.h"

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/likelihood/sensor_bias.h"

namespace mrpt_ext
{
namespace
{
SensorBias biasOf(const KalmanVector& mean, const BiasModel& biases, std::string_view sensor)
{
  SensorBias sum;
  for (std::size_t k = 0; k < biases.size(); ++k)
    if (actsOn(biases[k], sensor)) accumulate(sum, biases[k].kind, mean[3 + static_cast<int>(k)]);
  return sum;
}

KalmanRow rowOf(const JacobianRow& pose_part, Eigen::Index size)
{
  KalmanRow row;
  row.jacobian = KalmanRowVector::Zero(size);
  row.jacobian.head<3>() = pose_part;
  return row;
}
}  // namespace

DetectionRows linearise(const Detection& detection, const Reading& reading, const Landmark& landmark,
                        const KalmanVector& mean, const BiasModel& biases)
{
  const Pose2 robot{mean[0], mean[1], mean[2]};
  const Vector2d position = landmark.position.head<2>(), offset = reading.T_robot_sensor.position();
  const LandmarkPrediction unbiased = predict(landmark, reading, robot);
  const SensorBias bias = biasOf(mean, biases, reading.sensor);
  LandmarkPrediction biased = unbiased;
  applyBias(biased, bias);

  DetectionRows result;
  result.visibility = unbiased.visibility;
  const auto add_derivative = [&](KalmanRow& row, BiasKind kind, double value)
  {
    for (std::size_t k = 0; k < biases.size(); ++k)
      if (biases[k].kind == kind && actsOn(biases[k], reading.sensor)) row.jacobian[3 + static_cast<int>(k)] = value;
  };
  if (detection.bearing)
  {
    KalmanRow& row = result.rows[static_cast<std::size_t>(result.count++)];
    row = rowOf(bearingJacobian(robot, position, offset), mean.size());
    row.residual = wrap(*detection.bearing - biased.bearing);
    row.variance = square(detection.std_bearing) + biased.bearing_variance;
    add_derivative(row, BiasKind::bearing_offset, 1);
  }
  if (detection.range)
  {
    KalmanRow& row = result.rows[static_cast<std::size_t>(result.count++)];
    const double horizontal = predictRange(robot, position, reading.T_robot_sensor);
    const double slope =
        (1 + bias.range_scale) * horizontal / unbiased.range;  // of a slant range over a horizontal one
    row = rowOf(slope * rangeJacobian(robot, position, offset), mean.size());
    row.residual = *detection.range - biased.range;
    row.variance = square(detection.std_range) + biased.range_variance;
    add_derivative(row, BiasKind::range_offset, 1);
    add_derivative(row, BiasKind::range_scale, unbiased.range);
  }
  return result;
}

KalmanRow lineariseHeading(double heading, double std_heading, const KalmanVector& mean)
{
  KalmanRow row = rowOf({0, 0, 1}, mean.size());
  row.residual = wrap(heading - mean[2]);
  row.variance = square(std_heading);
  return row;
}
}  // namespace mrpt_ext
