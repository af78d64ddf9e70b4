#pragma once

#include <optional>
#include <string_view>
#include <utility>

namespace mrpt_ext
{
/// Width and height [pixels] that the header of a JPEG file states; nothing when it has none.
[[nodiscard]] std::optional<std::pair<double, double>> jpegSize(std::string_view bytes);

/// True when all of a JPEG file can be decoded without a single complaint of libjpeg, which otherwise repairs what it
/// reads and writes a warning.
[[nodiscard]] bool isWholeJpeg(std::string_view bytes);
}  // namespace mrpt_ext
