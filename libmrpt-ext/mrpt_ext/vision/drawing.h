#pragma once

#include <opencv2/imgproc.hpp>
#include <string>

namespace mrpt_ext
{
/// Of OpenCV's fixed-point drawing coordinates.
inline constexpr int kFractionBits = 4;

[[nodiscard]] inline cv::Point fixedPoint(const cv::Point2d& p)
{
  constexpr int kOne = 1 << kFractionBits;
  return {cvRound(p.x * kOne), cvRound(p.y * kOne)};
}

/// A copy to draw on: one channel becomes three.
[[nodiscard]] inline cv::Mat coloured(const cv::Mat& image)
{
  cv::Mat copy;
  if (image.channels() == 1)
    cv::cvtColor(image, copy, cv::COLOR_GRAY2BGR);
  else
    copy = image.clone();
  return copy;
}

inline void write(cv::Mat& drawing, const std::string& text, const cv::Point& position, const cv::Scalar& colour,
                  double size = 0.4)
{
  cv::putText(drawing, text, position, cv::FONT_HERSHEY_SIMPLEX, size, colour, 1, cv::LINE_AA);
}
}  // namespace mrpt_ext
