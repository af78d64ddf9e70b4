#pragma once

#include <string_view>

namespace mrpt_ext
{
/// The style sheet of the reports: style.css, built into the library.
[[nodiscard]] std::string_view reportStyle();
}  // namespace mrpt_ext
