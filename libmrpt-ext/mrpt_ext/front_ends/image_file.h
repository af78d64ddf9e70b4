#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

namespace mrpt_ext
{
/// The pixels of an image file, 8 bits, grey or BGR; or none and why. A missing file has neither.
struct ImageContent
{
  cv::Mat pixels;
  std::string problem;
};

/// Reads a JPEG or PNG file that is whole (image_integrity.h).
[[nodiscard]] ImageContent readImageFile(const std::filesystem::path& file);
}  // namespace mrpt_ext
