#pragma once

#include <functional>
#include <optional>

#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Position and heading of particle i as seen from `from`: x, y [m], phi [rad, wrapped].
[[nodiscard]] Vector3d offsetFrom(const Pose2& from, const ParticleSet& particles, std::size_t i);

/// Weighted mean and covariance, pose and systematic errors together, of the particles (normalised or not) that
/// `belongs` accepts. Nothing where too few belong for a covariance.
[[nodiscard]] std::optional<KalmanState> momentsOf(const ParticleSet& particles,
                                                   const std::function<bool(std::size_t)>& belongs);

/// True within `gate` standard deviations (Mahalanobis distance of the pose) of the state.
class PoseGate
{
 public:
  PoseGate(const KalmanState& state, double gate);
  [[nodiscard]] double distance2(const ParticleSet& particles, std::size_t i) const
  {
    const Vector3d d = offsetFrom(mean_, particles, i);
    return d.dot(information_ * d);
  }
  [[nodiscard]] bool contains(const ParticleSet& particles, std::size_t i) const
  {
    return distance2(particles, i) < gate2_;
  }

 private:
  Pose2 mean_;
  Matrix3d information_;
  double gate2_;
};

/// Standard normal vectors of this size, `count` of them as columns, shifted and scaled so that their mean is zero and
/// their covariance the identity exactly: what is drawn with them has the moments it is drawn for, however few they are
/// (second-order exact sampling; Pham, Mon. Weather Rev. 129, 2001).
[[nodiscard]] Eigen::MatrixXd exactNormals(Eigen::Index size, std::size_t count, RandomStream& random);

/// Particle i as a point of the state space, and the other way.
[[nodiscard]] KalmanVector pointOf(const ParticleSet& particles, std::size_t i);
void setPoint(ParticleSet& particles, std::size_t i, const KalmanVector& point);

/// Adds a particle at this point of the state space.
void addParticle(ParticleSet& particles, const KalmanVector& point, double log_w);

/// Logarithm of the Gaussian's density.
class GaussianDensity
{
 public:
  explicit GaussianDensity(const KalmanState& state);
  [[nodiscard]] double log(const KalmanVector& point) const;
  /// Lower Cholesky factor of the covariance.
  [[nodiscard]] const KalmanMatrix& factor() const { return factor_; }

 private:
  KalmanVector mean_;
  KalmanMatrix factor_;
  double log_norm_;
};
}  // namespace mrpt_ext
