#include "mrpt_ext/filter/kalman/kalman_state.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kMinStd = 1e-6;
constexpr int kPose = 3;

Matrix3d withFloor(Matrix3d covariance)
{
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  covariance.diagonal().array() += square(kMinStd);
  return covariance;
}

/// Sum of the errors of this kind.
double total(const KalmanVector& mean, const BiasModel& biases, BiasKind kind)
{
  double sum = 0;
  for (std::size_t k = 0; k < biases.size(); ++k)
    if (biases[k].kind == kind) sum += mean[kPose + static_cast<int>(k)];
  return sum;
}
}  // namespace

KalmanState startingState(const GaussianPose& pose, const BiasModel& biases)
{
  const int size = kPose + static_cast<int>(biases.size());
  KalmanState state{KalmanVector::Zero(size), KalmanMatrix::Zero(size, size)};
  state.mean.head<3>() = pose.mean.vector();
  state.covariance.topLeftCorner<3, 3>() = withFloor(pose.covariance);
  for (int k = kPose; k < size; ++k)
  {
    const BiasState& bias = biases[static_cast<std::size_t>(k - kPose)];
    state.mean[k] = bias.mean;
    state.covariance(k, k) = square(std::max(bias.std, kMinStd));
  }
  return state;
}

KalmanVector moved(const KalmanVector& mean, const KalmanVector& step)
{
  KalmanVector result = mean + step;
  result[2] = wrap(result[2]);
  return result;
}

namespace
{
/// The increment that the robot made according to a state, and the derivative of the next state by this one.
struct LinearisedMotion
{
  Pose2 increment;
  KalmanMatrix jacobian;
};

LinearisedMotion linearise(const KalmanState& state, const BiasModel& biases, const MotionModel& model,
                           const OdometryMotion& motion)
{
  const OdometryMotion nominal = nominalMotion(model, motion);
  const Pose2 measured = nominal.increment;
  const PathMoments moments = momentsOf(nominal);
  Vector3d missed = Vector3d::Zero();
  for (std::size_t k = 0; k < biases.size(); ++k)
    missed += state.mean[kPose + static_cast<int>(k)] * headingLever(biases[k].kind, moments);
  // The chord turns by half of what the heading missed, and by what the path was not even.
  const Matrix2d turned = rotation(0.5 * missed.z());
  const Vector2d left(-measured.y, measured.x);
  const Vector2d direction = turned * measured.position() + missed.head<2>() - 0.5 * missed.z() * left;
  const double distance_scale = total(state.mean, biases, BiasKind::distance_scale);
  const Vector2d chord = (1 + distance_scale) * direction;
  const Pose2 increment{chord.x(), chord.y(), measured.phi + missed.z()};

  const auto size = state.mean.size();
  const Pose2 before = state.pose();
  const Matrix3d G = composeJacobianSecond(before);
  KalmanMatrix F = KalmanMatrix::Identity(size, size);
  F.topLeftCorner<3, 3>() = composeJacobianFirst(before, increment);
  for (std::size_t k = 0; k < biases.size(); ++k)
  {
    const Vector3d lever = headingLever(biases[k].kind, moments);
    Vector3d by_error(direction.x(), direction.y(), 0);
    if (biases[k].kind != BiasKind::distance_scale)
    {
      const Vector2d end = lever.head<2>() + 0.5 * lever.z() * (turned * left - left);
      by_error << (1 + distance_scale) * end, lever.z();
    }
    if (belongsToOdometry(biases[k].kind)) F.block<3, 1>(0, kPose + static_cast<int>(k)) = G * by_error;
  }
  return {increment, F};
}
}  // namespace

KalmanMatrix motionJacobian(const KalmanState& state, const BiasModel& biases, const MotionModel& model,
                            const OdometryMotion& motion)
{
  return linearise(state, biases, model, motion).jacobian;
}

KalmanState predict(const KalmanState& state, const BiasModel& biases, const MotionModel& model,
                    const OdometryMotion& motion)
{
  const auto [increment, F] = linearise(state, biases, model, motion);
  const Matrix3d G = composeJacobianSecond(state.pose());
  KalmanState next = state;
  next.mean.head<3>() = compose(state.pose(), increment).vector();
  next.covariance = F * state.covariance * F.transpose();
  next.covariance.topLeftCorner<3, 3>() += G * incrementCovariance(model, motion) * G.transpose();
  for (std::size_t k = 0; k < biases.size(); ++k)
  {
    const int i = kPose + static_cast<int>(k);
    next.covariance(i, i) += square(biases[k].std_per_sqrt_s) * std::max(0.0, motion.duration);
  }
  next.covariance = (0.5 * (next.covariance + next.covariance.transpose())).eval();
  return next;
}
}  // namespace mrpt_ext
