#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/vision_front_end.h"

namespace mrpt_ext
{
/// The columns of frames.csv that name the images the configured sensor needs.
[[nodiscard]] std::vector<std::string> imageRoles(const Settings& settings);

/// Angle [rad] from the axis that headings in frames.csv count from to the configured sensor's forward axis.
[[nodiscard]] double headingOffset(const Settings& settings);

/// The front end of the configured sensor; `camera` is what the images state about it.
[[nodiscard]] std::unique_ptr<VisionFrontEnd> makeFrontEnd(const Settings& settings, const CameraFile& camera);
}  // namespace mrpt_ext
