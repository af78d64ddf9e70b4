#pragma once

#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
inline constexpr const char* kConicMirrorSection = "ConicMirror";
inline constexpr const char* kMovisSection = "Movis";
inline constexpr const char* kStereoGoalSection = "StereoGoal";
inline constexpr const char* kTagsSection = "Tags";
inline constexpr const char* kArucoOriginal = "aruco_original";  ///< of the key family, beside AprilTag's

/// The keys of images2rawlog's .ini files.
[[nodiscard]] KeyTable imagesKeys();

/// Size, focal lengths and centre of a pinhole camera: the first keys of a section.
[[nodiscard]] KeySection pinholeKeys(const std::string& section);

/// Those of one sensor each.
[[nodiscard]] KeyTable conicMirrorKeys();
[[nodiscard]] KeyTable movisKeys();
[[nodiscard]] KeyTable stereoGoalKeys();
[[nodiscard]] KeyTable tagsKeys();
}  // namespace mrpt_ext
