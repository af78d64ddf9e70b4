#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/range_scan.h"
#include "mrpt_ext/importers/sensor_poses.h"

namespace mrpt_ext
{
/// Reads laser scans from a table, plain or gzip, one row each: `t` [s]; `r0`, `r1`, ... the ranges [m], 0 without an
/// echo; `i0`, `i1`, ... the intensities, as many; and perhaps `sensor`, without which the sensor is called laser. The
/// bearings of the first and last beam are those in `sensors`. Ranges are taken to have a standard deviation of 0.02 m.
/// Throws InputError (data) with file and line.
[[nodiscard]] std::vector<RangeScan> readScanTable(const std::filesystem::path& path,
                                                   const std::map<std::string, SensorPose>& sensors);
}  // namespace mrpt_ext
