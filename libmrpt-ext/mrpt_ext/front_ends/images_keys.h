#pragma once

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
inline constexpr const char* kConicMirrorSection = "ConicMirror";
inline constexpr const char* kMovisSection = "Movis";
inline constexpr const char* kStereoGoalSection = "StereoGoal";

/// The keys of images2rawlog's .ini files.
[[nodiscard]] KeyTable imagesKeys();

/// Those of one sensor each.
[[nodiscard]] KeyTable conicMirrorKeys();
[[nodiscard]] KeyTable movisKeys();
[[nodiscard]] KeyTable stereoGoalKeys();
}  // namespace mrpt_ext
