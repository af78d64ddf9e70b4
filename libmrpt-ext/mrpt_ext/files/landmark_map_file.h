#pragma once

#include <filesystem>
#include <string>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// A map of landmarks in one of the formats below, by the ending of its name. Positions in metres, in the frame of the
/// file. Tags have the category `tag` and face where they can be read from, unless they lie or hang flat.
/// - .json: a WPILib field layout
/// - .yaml, .yml: tags.yaml of apriltag_ros
/// - else the CSV of landmark_csv.h
/// Throws InputError (data) on a missing or damaged file, an id that occurs twice or more landmarks than `limit`.
[[nodiscard]] LandmarkTable readLandmarkMapFile(const std::filesystem::path& path, const RowLimit& limit = {});

/// A WPILib field layout: `tags: [{ID, pose: {translation: {x, y, z}, rotation: {quaternion: {W, X, Y, Z}}}}]`; the x
/// axis of a tag is its normal, towards those who see it. `name` of the file, for errors.
[[nodiscard]] LandmarkTable parseFieldLayout(const std::string& text, const std::string& name,
                                             const RowLimit& limit = {});

/// tags.yaml of apriltag_ros: `tag_bundles: [{name, layout: [{id, x, y, z, qw, qx, qy, qz}]}]`; the z axis of a tag is
/// its normal, towards those who see it. One bundle is a map, and what its frame is has to be the map's; several are an
/// error. Standalone tags have no position and are left out.
[[nodiscard]] LandmarkTable parseTagBundle(const std::string& text, const std::string& name,
                                           const RowLimit& limit = {});
}  // namespace mrpt_ext
