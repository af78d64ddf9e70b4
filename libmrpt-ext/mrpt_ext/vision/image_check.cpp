#include "mrpt_ext/vision/image_check.h"

#include <opencv2/imgproc.hpp>

namespace mrpt_ext
{
namespace
{
constexpr int kSmallestSide = 64;  ///< [px] nothing can be measured in less

std::string text(const cv::Size& size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }
}  // namespace

std::string complaintAboutImage(const cv::Mat& image, const cv::Size& size)
{
  if (image.empty()) return "image is missing, empty or damaged";
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3))
    return "image has " + std::to_string(image.channels()) + " channels of " + std::to_string(8 * image.elemSize1()) +
           " bits, expected 1 or 3 of 8 bits";
  if (!size.empty() && image.size() != size)
    return "image is " + text(image.size()) + " pixels, expected " + text(size);
  if (std::min(image.cols, image.rows) < kSmallestSide)
    return "image is " + text(image.size()) + " pixels, expected at least " + std::to_string(kSmallestSide) +
           " either way";
  return "";
}

cv::Mat greyOf(const cv::Mat& image)
{
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}
}  // namespace mrpt_ext
