#include "mrpt_ext/filter/kernel_smoothing.h"

#include <Eigen/Cholesky>
#include <optional>

namespace mrpt_ext
{
namespace
{
constexpr double kMinWeight = 0.01;  // lighter modes are not worth it
constexpr double kReach2 = 16;       // squared Mahalanobis distance within which a particle belongs to a mode

struct SmoothedMode
{
  Pose2 mean;
  Matrix3d factor;       // lower Cholesky factor of the covariance
  Matrix3d information;  // inverse covariance
};

std::vector<SmoothedMode> compactModes(const ModeSet& modes, const KernelSmoothing& options)
{
  std::vector<SmoothedMode> compact;
  for (const Mode& mode : modes.modes)
  {
    const Matrix3d& C = mode.pose.covariance;
    const bool narrow = C(0, 0) + C(1, 1) < square(options.max_std_xy) && C(2, 2) < square(options.max_std_phi);
    if (mode.weight < kMinWeight || !narrow) continue;
    const Eigen::LLT<Matrix3d> llt(C);
    if (llt.info() != Eigen::Success) continue;  // all particles in one place: there is no spread to keep
    compact.push_back({mode.pose.mean, llt.matrixL(), llt.solve(Matrix3d::Identity())});
  }
  return compact;
}

Vector3d offsetFrom(const Pose2& mean, const Pose2& pose)
{
  return {pose.x - mean.x, pose.y - mean.y, wrap(pose.phi - mean.phi)};
}

/// The mode that the pose lies nearest to by Mahalanobis distance (a wide mode must not draw in a sharp one within its
/// reach); null when it belongs to none.
const SmoothedMode* nearestMode(const std::vector<SmoothedMode>& modes, const Pose2& pose)
{
  const SmoothedMode* nearest = nullptr;
  double smallest = kReach2;
  for (const SmoothedMode& mode : modes)
  {
    const Vector3d offset = offsetFrom(mode.mean, pose);
    const double distance2 = offset.dot(mode.information * offset);
    if (!(distance2 < smallest)) continue;
    smallest = distance2;
    nearest = &mode;
  }
  return nearest;
}
}  // namespace

void smoothModes(ParticleSet& particles, const ModeSet& modes, const KernelSmoothing& options, RandomStream& random)
{
  const std::vector<SmoothedMode> compact = compactModes(modes, options);
  const double keep = std::sqrt(1 - square(options.bandwidth));
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const SmoothedMode* nearest = nearestMode(compact, particles.pose(i));
    if (!nearest) continue;
    const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
    const Vector3d moved =
        keep * offsetFrom(nearest->mean, particles.pose(i)) + options.bandwidth * (nearest->factor * Vector3d(a, b, c));
    const Pose2& mean = nearest->mean;
    particles.setPose(i, {mean.x + moved.x(), mean.y + moved.y(), wrap(mean.phi + moved.z())});
  }
}
}  // namespace mrpt_ext
