#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Distance of a pose to a landmark, relative to that of the next one, below which it has no meaning.
inline constexpr double kClosestApproach = 1e-4;

/// A landmark matched to a bearing.
struct MatchedBearing
{
  Vector2d landmark{0, 0};
  double bearing = 0;   ///< [rad]
  Vector2d unit{1, 0};  ///< its cosine and sine
};

struct BearingFit
{
  Pose2 pose;
  double max_residual = 0;  ///< [rad]
};

/// Least-squares pose of three or more bearings of equal weight (Levenberg-Marquardt from `start`), as refinePose
/// but without covariance and without heap memory: most assignments of a search are not consistent.
[[nodiscard]] BearingFit fitBearings(std::span<const MatchedBearing> matched, const Pose2& start);

/// A start next to one of the landmarks, where its bearing hardly constrains the position: the pose that the other
/// bearings have there, moved to where the bearing of the landmark is right. Nothing when the landmark is farther
/// than `reach` from `about` and than a tenth of the distance to the next landmark, or when the others contradict
/// each other there by more than `error`.
[[nodiscard]] std::optional<Pose2> startNearLandmark(std::span<const MatchedBearing> matched, std::size_t close,
                                                     const Vector2d& about, double reach, double error);
}  // namespace mrpt_ext
