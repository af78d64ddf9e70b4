#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace mrpt_ext
{
/// The pixels of an image file, 8 bits, grey or BGR. Empty when the file is missing, no image, or cut off: decoders
/// fill what is missing with grey, in which edges would be found.
[[nodiscard]] cv::Mat readImageFile(const std::filesystem::path& file);
}  // namespace mrpt_ext
