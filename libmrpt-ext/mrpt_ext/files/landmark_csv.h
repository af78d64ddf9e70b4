#pragma once

#include <filesystem>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// Reads a map: `id,x,y,z,category` (+ optional `std_x,std_y`) in metres, and optional `yaw_deg,std_yaw_deg`, the
/// direction in which a landmark faces (empty: unknown); columns in any order, found by their header. `z`, `category`
/// and the standard deviations may be missing; an empty id is an anonymous landmark.
/// Throws InputError (data) on a missing file, a wrong header, a damaged row, an id that occurs twice or more rows than
/// `limit`.
[[nodiscard]] LandmarkTable readLandmarkCsv(const std::filesystem::path& path, const RowLimit& limit = {});

/// Writes a map that readLandmarkCsv() reads back without loss, angles to 1e-9 deg; the standard deviations only when
/// one is not zero, directions only when one is known.
void writeLandmarkCsv(const std::filesystem::path& path, const LandmarkTable& landmarks);
}  // namespace mrpt_ext
