#include "mrpt_ext/solvers/pose_information.h"

#include <Eigen/LU>

namespace mrpt_ext
{
Matrix3d poseInformation(std::span<const PoseMeasurement> measurements, const Pose2& pose)
{
  Matrix3d information = Matrix3d::Zero();
  for (const PoseMeasurement& m : measurements) addInformation(information, jacobian(m, pose), m.std);
  return information;
}

double informationRatio(const Matrix3d& information)
{
  const double position = 0.5 * (information(0, 0) + information(1, 1));
  const double heading = information(2, 2);
  if (!(position > 0 && heading > 0 && information.allFinite())) return 0;
  const Vector3d scale(1 / std::sqrt(position), 1 / std::sqrt(position), 1 / std::sqrt(heading));
  const Matrix3d scaled = scale.asDiagonal() * information * scale.asDiagonal();
  return std::max(0.0, scaled.determinant());
}

std::optional<Matrix3d> covarianceFromInformation(const Matrix3d& information)
{
  if (informationRatio(information) < kSingularInformationRatio) return std::nullopt;
  // Inverted in units in which all entries are of one size: lengths and angles differ by orders of magnitude.
  const double length = 1 / std::sqrt(0.5 * (information(0, 0) + information(1, 1)));
  const Vector3d scale(length, length, 1 / std::sqrt(information(2, 2)));
  const Matrix3d inverse = (scale.asDiagonal() * information * scale.asDiagonal()).inverse();
  const Matrix3d covariance = scale.asDiagonal() * inverse * scale.asDiagonal();
  if (!covariance.allFinite() || covariance.diagonal().minCoeff() <= 0) return std::nullopt;
  return 0.5 * (covariance + covariance.transpose());
}

std::optional<Matrix2d> covarianceFromInformation(const Matrix2d& information)
{
  const double size = square(0.5 * information.trace());
  if (!(size > 0) || !information.allFinite()) return std::nullopt;
  if (information.determinant() < kSingularInformationRatio * size) return std::nullopt;
  const Matrix2d covariance = information.inverse();
  return 0.5 * (covariance + covariance.transpose());
}
}  // namespace mrpt_ext
