#include "mrpt_ext/filter/motion/motion_model.h"

#include <algorithm>

#include "mrpt_ext/filter/motion/motion_kernel.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kCostOfMove = 15;  // of a particle, in operations (work_counter.h)

/// What the errors of the particles add to the motion, in the order of the model.
std::vector<BiasLever> biasLevers(const BiasModel& biases, const OdometryMotion& nominal)
{
  const PathMoments moments = momentsOf(nominal);
  const Vector2d chord = nominal.increment.position();
  std::vector<BiasLever> levers;
  for (const BiasState& bias : biases)
  {
    const Vector3d lever = headingLever(bias.kind, moments);
    levers.push_back({.turn = static_cast<float>(lever.z()),
                      .x = static_cast<float>(lever.x() + 0.5 * lever.z() * chord.y()),
                      .y = static_cast<float>(lever.y() - 0.5 * lever.z() * chord.x())});
  }
  return levers;
}

/// Lower factor L of a positive semidefinite matrix L L^T.
Matrix2d lowerFactor(const Matrix2d& matrix)
{
  Matrix2d factor = Matrix2d::Zero();
  factor(0, 0) = std::sqrt(std::max(0.0, matrix(0, 0)));
  if (factor(0, 0) > 0) factor(1, 0) = matrix(1, 0) / factor(0, 0);
  factor(1, 1) = std::sqrt(std::max(0.0, matrix(1, 1) - square(factor(1, 0))));
  return factor;
}
}  // namespace

OdometryMotion nominalMotion(const MotionModel& model, const OdometryMotion& motion)
{
  OdometryMotion nominal = motion;
  if (model.type == MotionType::random_walk)
  {
    nominal.increment = {};
    nominal.moments.reset();
  }
  return nominal;
}

Vector3d headingLever(BiasKind kind, const PathMoments& moments)
{
  switch (kind)
  {
    case BiasKind::rotation_scale:
      return moments.by_turn;
    case BiasKind::arc_scale:
      return moments.by_arc;
    case BiasKind::veer:
      return moments.by_length;
    case BiasKind::drift:
      return moments.by_time;
    default:
      return Vector3d::Zero();
  }
}

Vector3d incrementStd(const MotionModel& model, const OdometryMotion& motion)
{
  const double time_xy = square(model.std_xy_per_s) * motion.duration;
  const double distance_xy = square(model.std_xy_per_m) * motion.path_length;
  const double phi = square(model.std_phi_per_deg) * motion.turned * degToRad(1.0) +
                     square(model.std_phi_per_m) * motion.path_length + square(model.std_phi_per_s) * motion.duration;
  const double across = model.type == MotionType::velocity ? time_xy : time_xy + distance_xy;
  return {std::sqrt(time_xy + distance_xy), std::sqrt(across), std::sqrt(phi)};
}

Matrix3d incrementCovariance(const MotionModel& model, const OdometryMotion& motion)
{
  const Vector3d std = incrementStd(model, motion);
  const PathMoments moments = momentsOf(nominalMotion(model, motion));
  Matrix3d covariance = Vector3d(square(std.x()), square(std.y()), 0).asDiagonal();
  covariance += square(model.std_phi_per_deg) * degToRad(1.0) * moments.turned;
  covariance += square(model.std_phi_per_m) * moments.length + square(model.std_phi_per_s) * moments.time;
  return covariance + motion.excess;
}

PerNoiseSource<Matrix3d> covarianceBySource(const MotionModel& model, const OdometryMotion& motion)
{
  OdometryMotion stated = motion;
  stated.excess.setZero();
  const MotionModel none{model.type, 0, 0, 0, 0, 0};
  MotionModel position = none, turning = none, path = none, time = none;
  position.std_xy_per_m = model.std_xy_per_m;
  position.std_xy_per_s = model.std_xy_per_s;
  turning.std_phi_per_deg = model.std_phi_per_deg;
  path.std_phi_per_m = model.std_phi_per_m;
  time.std_phi_per_s = model.std_phi_per_s;
  return {incrementCovariance(position, stated), incrementCovariance(turning, stated),
          incrementCovariance(path, stated), incrementCovariance(time, stated)};
}

void sampleMotion(ParticleSet& particles, const MotionModel& model, const OdometryMotion& motion, RandomStream& random,
                  unsigned threads)
{
  // The error of the heading swings the chord; what else errs in position is independent of it.
  const Matrix3d C = incrementCovariance(model, motion);
  const double std_turn = std::sqrt(C(2, 2));
  const Vector2d swing = std_turn > 0 ? Vector2d(C.topRightCorner<2, 1>() / C(2, 2)) : Vector2d::Zero();
  const Matrix2d factor = lowerFactor(C.topLeftCorner<2, 2>() - C(2, 2) * swing * swing.transpose());
  const Pose2 mean = nominalMotion(model, motion).increment;
  const MotionStep step{.x = static_cast<float>(mean.x),
                        .y = static_cast<float>(mean.y),
                        .turn = static_cast<float>(mean.phi),
                        .xa = static_cast<float>(factor(0, 0)),
                        .ya = static_cast<float>(factor(1, 0)),
                        .yb = static_cast<float>(factor(1, 1)),
                        .swing_x = static_cast<float>(swing.x()),
                        .swing_y = static_cast<float>(swing.y()),
                        .std_turn = static_cast<float>(std_turn)};
  const std::vector<BiasLever> levers = biasLevers(particles.bias_states, nominalMotion(model, motion));
  const std::uint64_t seed = random.nextBits();
  WorkCounter::add(kCostOfMove * particles.size());
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 SimdRandom lanes(seed, first / kParticleBlock);
                 moveBlock(particles, step, levers, first, count, lanes);
               });
}
}  // namespace mrpt_ext
