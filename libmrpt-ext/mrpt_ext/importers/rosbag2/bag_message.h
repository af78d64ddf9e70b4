#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// A topic of a bag.
struct BagTopic
{
  std::string name;        ///< "/scan"
  std::string type;        ///< "sensor_msgs/msg/LaserScan"
  std::string encoding;    ///< of the messages: "cdr"
  std::string definition;  ///< ros2msg text with its dependencies; empty: not in the bag
};

/// A recorded message; both views hold during the call that hands it over.
struct BagMessage
{
  const BagTopic& topic;
  double time = 0;           ///< [s] when it was recorded
  std::uint64_t number = 0;  ///< in its file, from 0
  std::string_view data;
};

using BagMessageSink = std::function<void(const BagMessage&)>;
}  // namespace mrpt_ext
