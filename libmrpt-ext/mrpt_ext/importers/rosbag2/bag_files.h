#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mrpt_ext/importers/rosbag2/bag_message.h"

namespace mrpt_ext
{
/// Reads the messages of a recording of ROS 2's rosbag2: a file (.mcap, .db3; zstd behind them is unpacked), several
/// files in this order, or a folder with metadata.yaml, which names them. What a file is, its first bytes tell. Returns
/// notes. Throws InputError (data), with file and record, for damage, and for DamagedBytes that `sink` throws.
[[nodiscard]] std::vector<std::string> readBag(const std::vector<std::filesystem::path>& inputs,
                                               const BagMessageSink& sink);
}  // namespace mrpt_ext
