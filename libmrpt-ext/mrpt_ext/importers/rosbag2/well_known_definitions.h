#pragma once

#include <string>
#include <vector>

namespace mrpt_ext
{
/// Definitions of a message type ("pkg/msg/Name") for bags that bring none: one for each version of it that differs,
/// the newest first; empty for types that are not read.
[[nodiscard]] std::vector<std::string> wellKnownDefinitions(const std::string& type);
}  // namespace mrpt_ext
