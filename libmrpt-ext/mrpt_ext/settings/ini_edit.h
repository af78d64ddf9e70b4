#pragma once

#include <string>
#include <vector>

namespace mrpt_ext
{
/// A line that a configuration should have.
struct IniAssignment
{
  std::string section, key, value;
};

/// The text of an .ini with the lines set: a key that is there gets the new value and keeps its place and comment, a
/// new one is added at the end of its section, a new section at the end of the file.
[[nodiscard]] std::string withValues(const std::string& ini, const std::vector<IniAssignment>& lines);
}  // namespace mrpt_ext
