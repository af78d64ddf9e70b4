#pragma once

#include <string_view>

namespace mrpt_ext
{
/// Version of this project, as in CMakeLists.txt.
[[nodiscard]] std::string_view version();
/// Compiler and libraries with their versions.
[[nodiscard]] std::string_view builtWith();
}  // namespace mrpt_ext
