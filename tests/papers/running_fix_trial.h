#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/solvers/pose_measurement.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext::papers
{
/// A robot that measures the range to one landmark, drives on, and measures it again.
struct FixScene
{
  Pose2 first, second;  ///< true poses; it does not turn on the way
  Vector2d landmark{0, 0};
};

/// Standard deviations, as they are and as the estimators are told.
struct FixNoise
{
  double first_range = 0, second_range = 0;  ///< [m]
  double displacement = 0;                   ///< [m] of each axis of the way
  double heading = 0;                        ///< [rad]
  double bearing = 0;                        ///< [rad] of the landmark, at the second place
};

struct FixMeasurement
{
  RunningFixReading reading;
  HeadingPrior heading;
  Vector2d landmark{0, 0};
};

/// Way, heading and bearing with noise, ranges as given.
[[nodiscard]] FixMeasurement measureFix(const FixScene& scene, double first_range, double second_range,
                                        const FixNoise& noise, RandomStream& random);

/// Eq 1-6 with the heading that was measured; of the two candidates the one that the bearing speaks for. Where the
/// circles miss each other: `from_gap`.
[[nodiscard]] std::optional<RunningFixPose> closedFormFix(const FixMeasurement& measured);

/// The most likely pose from both ranges, the bearing and the heading.
[[nodiscard]] std::optional<GaussianPose> likeliestFix(const FixMeasurement& measured);

/// Cramer-Rao bound of the second position, from the two ranges and the heading, and with the bearing too.
[[nodiscard]] std::optional<Matrix2d> fixBound(const FixScene& scene, const FixNoise& noise, bool with_bearing);
}  // namespace mrpt_ext::papers
