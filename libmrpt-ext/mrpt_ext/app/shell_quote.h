#pragma once

#include <string>
#include <vector>

namespace mrpt_ext
{
/// The words as a line that a POSIX shell splits into the same words again.
[[nodiscard]] std::string shellLine(const std::vector<std::string>& words);
}  // namespace mrpt_ext
