#pragma once

#include <filesystem>

#include "mrpt_ext/vision/tags/tag_dictionary.h"

namespace mrpt_ext
{
/// A dictionary of tags in OpenCV's form, YAML with `nmarkers`, `markersize` (3 to 8 cells along an edge) and for each
/// of them `marker_0: "1011..."`, the cells row by row, 1 is white. Throws InputError (configuration).
[[nodiscard]] TagDictionary readTagDictionary(const std::filesystem::path& file);
}  // namespace mrpt_ext
