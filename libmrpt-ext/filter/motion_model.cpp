#include "mrpt_ext/filter/motion_model.h"

namespace mrpt_ext
{
Vector3d incrementStd(const MotionModel& model, const OdometryMotion& motion)
{
  const double time_xy = square(model.std_xy_per_s) * motion.duration;
  const double way_xy = square(model.std_xy_per_m) * motion.path_length;
  const double phi = square(model.std_phi_per_deg) * motion.turned * degToRad(1.0) +
                     square(model.std_phi_per_m) * motion.path_length + square(model.std_phi_per_s) * motion.duration;
  const double across = model.type == MotionType::velocity ? time_xy : time_xy + way_xy;
  return {std::sqrt(time_xy + way_xy), std::sqrt(across), std::sqrt(phi)};
}

Matrix3d incrementCovariance(const MotionModel& model, const OdometryMotion& motion)
{
  return incrementStd(model, motion).cwiseAbs2().asDiagonal();
}

void moveParticles(ParticleSet& particles, const MotionModel& model, const OdometryMotion& motion, RandomStream& random)
{
  const Vector3d std = incrementStd(model, motion);
  const bool measured = model.type != MotionType::random_walk;
  const Pose2 mean = measured ? motion.increment : Pose2{};
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double dx = mean.x + std.x() * random.gaussian();
    const double dy = mean.y + std.y() * random.gaussian();
    const double dphi = mean.phi + std.z() * random.gaussian();
    const Pose2 moved = compose(particles.pose(i), {dx, dy, dphi});
    particles.x[i] = moved.x;
    particles.y[i] = moved.y;
    particles.phi[i] = moved.phi;
  }
}
}  // namespace mrpt_ext
