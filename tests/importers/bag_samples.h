#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/importers/rosbag2/bag_message.h"

namespace mrpt_ext::testing
{
/// A bag made by programs of others, see tests/data/rosbag2/README.md.
inline std::filesystem::path bag(const std::string& name)
{
  return std::filesystem::path(MRPT_EXT_TEST_DATA) / "rosbag2" / name;
}

/// The topics of the messages that `read` hands over, in order.
inline std::vector<std::string> topicsOf(const std::function<void(const BagMessageSink&)>& read)
{
  std::vector<std::string> topics;
  read([&](const BagMessage& message) { topics.push_back(message.topic.name); });
  return topics;
}
}  // namespace mrpt_ext::testing
