#pragma once

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
/// The keys of images2rawlog's .ini files.
[[nodiscard]] KeyTable imagesKeys();

/// Those of one sensor each.
[[nodiscard]] KeyTable conicMirrorKeys();
[[nodiscard]] KeyTable movisKeys();
[[nodiscard]] KeyTable stereoGoalKeys();
}  // namespace mrpt_ext
