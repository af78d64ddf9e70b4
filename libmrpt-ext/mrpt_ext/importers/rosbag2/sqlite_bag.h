#pragma once

#include <filesystem>
#include <string_view>

#include "mrpt_ext/importers/rosbag2/bag_message.h"

namespace mrpt_ext
{
/// Reads the messages of an sqlite3 bag file (.db3): its tables topics, messages and, where the bag has them,
/// message_definitions. Throws InputError (data) with the file.
void readSqliteBag(const std::filesystem::path& path, const BagMessageSink& sink);

/// Whether a file that begins with these bytes is an sqlite3 file.
[[nodiscard]] bool isSqlite(std::string_view start);
}  // namespace mrpt_ext
