#pragma once

#include <array>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
enum class MotionType
{
  odometry,    ///< measured displacement, noise along and across
  velocity,    ///< commanded velocities integrated as arcs: noise along the path and in heading only
  random_walk  ///< no odometry: any slow motion
};

/// Noise of the odometry. Each value is a standard deviation after one unit of distance, rotation or time; variances
/// add up, so the result does not depend on how often odometry is read.
struct MotionModel
{
  MotionType type = MotionType::odometry;
  double std_xy_per_m = 0.05;            ///< [m] after one metre
  double std_phi_per_deg = 0.3;          ///< [deg] after a rotation of one degree; grows with the root of the rotation
  double std_phi_per_m = degToRad(1.0);  ///< [rad] after one metre
  double std_xy_per_s = 0.005;           ///< [m] after one second, also at standstill
  double std_phi_per_s = degToRad(0.3);  ///< [rad] after one second, also at standstill
};

/// A log without odometry: a robot or a person at walking speed, turning at will.
[[nodiscard]] inline MotionModel walkingSpeedRandomWalk()
{
  return {.type = MotionType::random_walk, .std_xy_per_s = 0.5, .std_phi_per_s = degToRad(30.0)};
}

/// The motion without noise: the measured one, or none for a random walk (its noise covers the motion).
[[nodiscard]] OdometryMotion nominalMotion(const MotionModel& model, const OdometryMotion& motion);

/// Derivative of the increment (x, y, phi) by a systematic error of the heading; zero for errors of other kinds.
[[nodiscard]] Vector3d headingLever(BiasKind kind, const PathMoments& moments);

/// Standard deviations (x, y, phi) that `motion` adds by itself, in the robot frame at its start.
[[nodiscard]] Vector3d incrementStd(const MotionModel& model, const OdometryMotion& motion);

/// Covariance of the increment: the square of incrementStd, and the effect of the heading errors, which arise along the
/// path, on the position (path_moments.h). So one long motion spreads like many short ones. The motion's excess is
/// added.
[[nodiscard]] Matrix3d incrementCovariance(const MotionModel& model, const OdometryMotion& motion);

/// Where the stated noise comes from: the position; the heading by turning, per metre, and with time.
inline constexpr std::size_t kNoiseSources = 4;
template <typename Value>
using PerNoiseSource = std::array<Value, kNoiseSources>;

/// The stated part of incrementCovariance() as a sum over its sources.
[[nodiscard]] PerNoiseSource<Matrix3d> covarianceBySource(const MotionModel& model, const OdometryMotion& motion);

/// Moves every particle by the increment plus noise of its own (drawn from incrementCovariance, added to the increment,
/// then composed). Systematic errors of odometry that a particle carries act on the increment before its noise.
/// One number is drawn from `random`, which seeds all blocks of particles; `threads` change nothing but the time.
void sampleMotion(ParticleSet& particles, const MotionModel& model, const OdometryMotion& motion, RandomStream& random,
                  unsigned threads = 1);
}  // namespace mrpt_ext
