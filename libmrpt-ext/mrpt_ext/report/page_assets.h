#pragma once

#include <string_view>

namespace mrpt_ext
{
/// Style sheet and scripts of the pages, built into the library from the files in `page`, so that a report needs no
/// other file. None of them contains an address.

/// Our style sheet and that of the chart library.
[[nodiscard]] std::string_view pageStyle();
/// Our scripts, one after the other.
[[nodiscard]] std::string_view pageScript();
/// Dygraphs, as Debian packages it.
[[nodiscard]] std::string_view chartLibrary();
/// Canvas and controls of the playback.
[[nodiscard]] std::string_view playbackMarkup();
}  // namespace mrpt_ext
