#pragma once

#include <string>
#include <string_view>

namespace mrpt_ext
{
/// No camera of a robot has more pixels; what a file states beyond that is damage, not a larger allocation.
inline constexpr double kMostPixels = 50e6;

/// Why nothing can be measured in the bytes of an image file; empty when they are a whole JPEG or PNG image. Decoders
/// take damage for granted: they fill what is missing with grey and go on, and edges would be found there.
[[nodiscard]] std::string whyNoImage(std::string_view bytes);
}  // namespace mrpt_ext
