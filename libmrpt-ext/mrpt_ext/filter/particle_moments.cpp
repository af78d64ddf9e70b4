#include "mrpt_ext/filter/particle_moments.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinMomentVariance = 1e-12;
constexpr std::size_t kCostOfMoments = 50;  // of a particle, in operations (work_counter.h)
}  // namespace

Vector3d offsetFrom(const Pose2& from, const ParticleSet& particles, std::size_t i)
{
  const Pose2 pose = particles.pose(i);
  return {pose.x - from.x, pose.y - from.y, wrap(pose.phi - from.phi)};
}

std::optional<KalmanState> momentsOf(const ParticleSet& particles, const std::function<bool(std::size_t)>& belongs)
{
  const auto size = 3 + static_cast<Eigen::Index>(particles.bias.size());
  KalmanVector reference, sum = KalmanVector::Zero(size);  // offsets from the first, for headings and for rounding
  KalmanMatrix squares = KalmanMatrix::Zero(size, size);
  double weight = 0, weight2 = 0;
  WorkCounter::add(kCostOfMoments * particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    if (!belongs(i)) continue;
    KalmanVector d = pointOf(particles, i);
    if (reference.size() == 0) reference = d;
    d -= reference;
    d[2] = wrap(d[2]);
    const double w = std::exp(double{particles.log_weight[i]});
    weight += w;
    weight2 += w * w;
    sum += w * d;
    squares += w * d * d.transpose();
  }
  const auto least = static_cast<double>(2 * size);
  if (!(weight > 0) || weight * weight < least * weight2) return std::nullopt;
  sum /= weight;
  KalmanState state{moved(reference, sum), squares / weight - sum * sum.transpose()};
  state.covariance.diagonal().array() += kMinMomentVariance;
  return state;
}

PoseGate::PoseGate(const KalmanState& state, double gate)
    : mean_(state.pose()), information_(state.gaussianPose().covariance.inverse()), gate2_(gate * gate)
{
}

Eigen::MatrixXd exactNormals(Eigen::Index size, std::size_t count, RandomStream& random)
{
  Eigen::MatrixXd draws(size, static_cast<Eigen::Index>(count));
  for (double& value : draws.reshaped()) value = random.gaussian();
  if (static_cast<Eigen::Index>(count) < 3 * size) return draws;
  draws.colwise() -= draws.rowwise().mean().eval();
  const Eigen::MatrixXd covariance = draws * draws.transpose() / static_cast<double>(count);
  covariance.llt().matrixL().solveInPlace(draws);
  return draws;
}

KalmanVector pointOf(const ParticleSet& particles, std::size_t i)
{
  KalmanVector point(3 + static_cast<Eigen::Index>(particles.bias.size()));
  point.head<3>() = particles.pose(i).vector();
  for (std::size_t k = 0; k < particles.bias.size(); ++k)
    point[3 + static_cast<Eigen::Index>(k)] = double{particles.bias[k][i]};
  return point;
}

void setPoint(ParticleSet& particles, std::size_t i, const KalmanVector& point)
{
  particles.setPose(i, {point[0], point[1], wrap(point[2])});
  for (std::size_t k = 0; k < particles.bias.size(); ++k)
    particles.bias[k][i] = static_cast<float>(point[3 + static_cast<Eigen::Index>(k)]);
}

void addParticle(ParticleSet& particles, const KalmanVector& point, double log_w)
{
  particles.add({point[0], point[1], wrap(point[2])}, log_w);
  for (std::size_t k = 0; k < particles.bias.size(); ++k)
    particles.bias[k].back() = static_cast<float>(point[3 + static_cast<Eigen::Index>(k)]);
}

GaussianDensity::GaussianDensity(const KalmanState& state) : mean_(state.mean)
{
  factor_ = state.covariance.llt().matrixL();
  log_norm_ = -0.5 * static_cast<double>(mean_.size()) * std::log(kTwoPi) - factor_.diagonal().array().log().sum();
}

double GaussianDensity::log(const KalmanVector& point) const
{
  KalmanVector d = point - mean_;
  d[2] = wrap(d[2]);
  factor_.triangularView<Eigen::Lower>().solveInPlace(d);
  return log_norm_ - 0.5 * d.squaredNorm();
}
}  // namespace mrpt_ext
