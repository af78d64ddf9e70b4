#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/conic_mirror.h"
#include "mrpt_ext/vision/mirror_alignment.h"

namespace mrpt_ext
{
/// Aligns the mirror over a sequence of images: its axes are constants of the sensor, and the edges that they bend are
/// in every image. Every round looks at the images about the axes of the round before, since edges that are bent too
/// much are not seen whole; what makes most parts of edges straight is taken.
///
/// With an axis in the settings the rim's distance from its principal point tells the offset of the mirror from a tilt
/// of the camera. Without, edges alone hardly do (one explains what two others together do), so one cause is taken: an
/// offset, a tilt of the camera or one of the vertical; the mirror is then taken for one of `kUsualCone` and
/// `kUsualRim`. Nothing when too few edges can be compared.
[[nodiscard]] std::optional<MirrorAlignment> calibrateMirror(const std::vector<cv::Mat>& images,
                                                             const ConicMirrorSettings& settings);

constexpr double kUsualCone = 0.91;  ///< [rad] half angle
constexpr double kUsualRim = 0.42;   ///< [rad] between the camera's axis and the rim
}  // namespace mrpt_ext
