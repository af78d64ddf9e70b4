#include "mrpt_ext/filter/bias_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/geometry/mahalanobis.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSameGate = 3;  // standard deviations, of both estimates of the pose together
constexpr double kModeGate = 5;  // standard deviations that the particles of the mode are within
}  // namespace

BiasFilter::BiasFilter(MotionModel motion, BiasModel biases)
    : motion_(motion), biases_(std::move(biases)), state_(startingState({}, biases_))
{
}

void BiasFilter::follow(const std::optional<KalmanState>& now, const Frame& frame, const LandmarkTable& map)
{
  if (biases_.empty()) return;
  state_ = predict(state_, biases_, motion_, frame.motion);
  if (following_ && now)
  {
    const std::optional<Frame> affordable = affordableToUpdate(frame, map, 1);
    state_ = updateIterated(state_, affordable ? *affordable : frame, map, biases_).state;
    following_ = agree(state_.gaussianPose(), now->gaussianPose(), kSameGate);
    if (!following_) state_ = startingState({}, biases_);  // learned elsewhere
  }
  else
    following_ = false;
  if (now && !following_) start(*now);
}

void BiasFilter::start(const KalmanState& now)
{
  const Eigen::Index count = state_.mean.size() - 3;
  state_.mean.head<3>() = now.mean.head<3>();
  state_.covariance.topLeftCorner<3, 3>() = now.covariance.topLeftCorner<3, 3>();
  state_.covariance.topRightCorner(3, count).setZero();
  state_.covariance.bottomLeftCorner(count, 3).setZero();
  following_ = true;
}

void BiasFilter::draw(ParticleSet& particles, RandomStream& random) const
{
  if (!following_) return;
  const auto count = static_cast<Eigen::Index>(particles.bias.size());
  const KalmanMatrix& P = state_.covariance;
  const Eigen::MatrixXd gain = P.bottomLeftCorner(count, 3) * P.topLeftCorner<3, 3>().inverse();
  const Eigen::MatrixXd conditional = P.bottomRightCorner(count, count) - gain * P.topRightCorner(3, count);
  const Eigen::LLT<Eigen::MatrixXd> factor(conditional);
  if (factor.info() != Eigen::Success) return;
  const PoseGate gate(state_, kModeGate);
  Eigen::VectorXd noise(count);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    if (!gate.contains(particles, i)) continue;
    for (double& value : noise) value = random.gaussian();
    const Eigen::VectorXd drawn =
        state_.mean.tail(count) + gain * offsetFrom(state_.pose(), particles, i) + factor.matrixL() * noise;
    for (Eigen::Index k = 0; k < count; ++k)
      particles.bias[static_cast<std::size_t>(k)][i] = static_cast<float>(drawn[k]);
  }
}

std::optional<std::vector<BiasEstimate>> BiasFilter::estimates() const
{
  if (!following_) return std::nullopt;
  std::vector<BiasEstimate> found;
  for (Eigen::Index k = 3; k < state_.mean.size(); ++k)
    found.push_back({state_.mean[k], std::sqrt(state_.covariance(k, k))});
  return found;
}
}  // namespace mrpt_ext
