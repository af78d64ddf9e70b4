#pragma once

#include <cstddef>

namespace mrpt_ext
{
/// Counts of one observation class in the log.
struct ObservationCount
{
  std::size_t total = 0, used = 0, ignored = 0;
};
}  // namespace mrpt_ext
