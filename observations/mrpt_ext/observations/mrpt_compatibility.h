#pragma once

#include <memory>

/// What differs between the versions of MRPT that we build with (2.5.8 to 2.15), in one place.
namespace mrpt_ext
{
/// Hands a new map to MRPT, whose TMetricMapInitializer takes a plain pointer before 2.11.3 and a std::shared_ptr
/// since: `Result` is what the function that MAP_DEFINITION_END declares returns.
template <typename Result, typename Map>
[[nodiscard]] Result handOver(std::unique_ptr<Map> map)
{
  return Result(map.release());
}
}  // namespace mrpt_ext
