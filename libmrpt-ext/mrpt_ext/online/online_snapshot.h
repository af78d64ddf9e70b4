#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/filter_diagnostics.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// What an OnlineLocalizer leaves for the next one.
struct OnlineSnapshot
{
  std::optional<GaussianPose> pose;  ///< absent: unknown
  std::vector<BiasEstimate> biases;  ///< systematic errors, in the order of their model
};

/// One line: name and version of the format, number of poses (0 or 1), pose and upper triangle of its covariance,
/// number of systematic errors, mean and standard deviation of each. Numbers are read back without loss.
[[nodiscard]] std::string textOf(const OnlineSnapshot& snapshot);
/// Throws InputError (data) for anything else.
[[nodiscard]] OnlineSnapshot snapshotFrom(const std::string& text);
}  // namespace mrpt_ext
