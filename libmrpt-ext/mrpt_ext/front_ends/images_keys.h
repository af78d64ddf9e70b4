#pragma once

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
inline constexpr const char* kConicMirrorSection = "ConicMirror";
inline constexpr const char* kMovisSection = "Movis";
inline constexpr const char* kStereoGoalSection = "StereoGoal";
inline constexpr const char* kTagsSection = "Tags";
inline constexpr const char* kArucoOriginal = "aruco_original";  ///< of the key family, beside AprilTag's

/// The keys of images2rawlog's .ini files.
[[nodiscard]] KeyTable imagesKeys();

/// Those of one sensor each.
[[nodiscard]] KeyTable conicMirrorKeys();
[[nodiscard]] KeyTable movisKeys();
[[nodiscard]] KeyTable stereoGoalKeys();
[[nodiscard]] KeyTable tagsKeys();
}  // namespace mrpt_ext
