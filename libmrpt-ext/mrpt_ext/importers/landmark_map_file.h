#pragma once

#include <filesystem>

#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// A map of landmarks in one of the formats below, by the ending of its name. Positions in metres, in the frame of the
/// file; headings of tags are not used.
/// - .json: a WPILib field layout: `tags: [{ID, pose: {translation: {x, y, z}}}]`
/// - .yaml, .yml: tags.yaml of apriltag_ros: `tag_bundles: [{name, layout: [{id, x, y, z}]}]`; one bundle is a map, and
///   what its frame is has to be the map's. Standalone tags have no position and are left out.
/// - else the CSV of landmark_csv.h
/// Throws InputError (data) on a missing or damaged file, an id that occurs twice, and several bundles.
[[nodiscard]] LandmarkTable readLandmarkMapFile(const std::filesystem::path& path);
}  // namespace mrpt_ext
