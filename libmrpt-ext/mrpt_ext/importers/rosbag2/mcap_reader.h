#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mrpt_ext/importers/rosbag2/bag_message.h"

namespace mrpt_ext
{
/// Reads the messages of an MCAP file (https://mcap.dev/spec) from front to back, so that no index is needed; chunks
/// plain, lz4 or zstd, with their checksums. A recording that was cut off is read up to its last whole record; returned
/// are notes about that. Throws InputError (data) with file and byte for damage.
[[nodiscard]] std::vector<std::string> readMcap(const std::filesystem::path& path, const BagMessageSink& sink);

/// Whether a file that begins with these bytes is an MCAP file.
[[nodiscard]] bool isMcap(std::string_view start);
}  // namespace mrpt_ext
