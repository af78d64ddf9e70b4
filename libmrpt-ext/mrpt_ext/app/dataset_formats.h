#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/importers/import_options.h"

namespace mrpt_ext
{
/// The recording to import, and how.
struct DatasetRequest
{
  std::string format;
  std::vector<std::filesystem::path> inputs;
  std::optional<int> robot;            ///< mrclam, mrclam-snapshots
  std::optional<double> wheelbase;     ///< [m] csv: distance of the axles of a car
  std::optional<double> wheel_offset;  ///< [m] csv: of the wheel that measures the speed
  std::filesystem::path map;           ///< mrpt-uwb: other beacon positions than the demo's; rosbag2: the landmarks
  std::vector<std::string> topics;     ///< rosbag2: ROLE=NAME
  std::string base;                    ///< csv, rosbag2: the sensor or frame that is the robot's
  std::optional<Pose2> truth_origin;   ///< mrpt-uwb: pose of the truth file's frame in the map
  IdentityLevel identity = IdentityLevel::known;
  MeasurementSelection measurements = MeasurementSelection::range_bearing;
};

/// Names of the formats that can be read.
[[nodiscard]] std::vector<std::string> datasetFormats();
/// One line per format: its name and what INPUT is.
[[nodiscard]] std::string describeDatasetFormats();

/// Reads a recording of any format. Throws InputError: configuration for an unknown format, a wrong number of inputs or
/// an option that the format does not have, data for files that cannot be used.
[[nodiscard]] Recording importDataset(const DatasetRequest& request);
}  // namespace mrpt_ext
