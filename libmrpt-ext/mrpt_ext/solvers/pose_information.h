#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// Fisher information of the pose, order (x, y, phi), from independent measurements: sum J^T J / sigma^2.
[[nodiscard]] Matrix3d poseInformation(std::span<const PoseMeasurement> measurements, const Pose2& pose);

/// How far the information is from singular: det(F) / ((F_xx + F_yy)^2 / 4 * F_phiphi), in [0, 1]. Independent of the
/// unit of length and of the axes. 0 when a direction is not seen at all (two bearings; ranges alone; robot and
/// landmarks on one circle).
[[nodiscard]] double informationRatio(const Matrix3d& information);

/// Below this ratio the inverse is rounding noise.
inline constexpr double kSingularInformationRatio = 1e-12;

/// Inverse of the information; nothing when it is singular.
[[nodiscard]] std::optional<Matrix3d> covarianceFromInformation(const Matrix3d& information);

/// The same for a position: nothing when det < 1e-12 (trace / 2)^2.
[[nodiscard]] std::optional<Matrix2d> covarianceFromInformation(const Matrix2d& information);
}  // namespace mrpt_ext
