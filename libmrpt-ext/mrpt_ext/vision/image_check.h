#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace mrpt_ext
{
/// Why `image` cannot be used: "image is missing, empty or damaged", "image has 4 channels ...", "image is
/// 320x240, expected 640x480"; empty when it can. `size` is that of the camera; empty: any.
[[nodiscard]] std::string complaintAboutImage(const cv::Mat& image, const cv::Size& size);

/// 8-bit grey from an 8-bit grey or BGR image.
[[nodiscard]] cv::Mat greyOf(const cv::Mat& image);
}  // namespace mrpt_ext
