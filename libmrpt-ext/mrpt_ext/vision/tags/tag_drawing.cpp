#include "mrpt_ext/vision/drawing.h"
#include "mrpt_ext/vision/tags/tag_view.h"

namespace mrpt_ext
{
namespace
{
const cv::Scalar kTagBorder(80, 220, 80), kTagText(60, 60, 255);
}  // namespace

cv::Mat drawTags(const cv::Mat& image, const TagView& view)
{
  if (image.empty() || image.depth() != CV_8U) return {};
  cv::Mat drawing = coloured(image);
  if (!view.problem.empty()) write(drawing, view.problem, {10, 24}, kTagText);
  for (const SeenTag& tag : view.tags)
  {
    cv::Point2d middle;
    for (std::size_t i = 0; i < tag.corners.size(); ++i)
    {
      const Eigen::Vector2d &a = tag.corners[i], &b = tag.corners[(i + 1) % tag.corners.size()];
      cv::line(drawing, fixedPoint({a.x(), a.y()}), fixedPoint({b.x(), b.y()}), kTagBorder, 1, cv::LINE_AA,
               kFractionBits);
      middle += 0.25 * cv::Point2d(a.x(), a.y());
    }
    const std::string text = std::to_string(tag.id) + ": " + cv::format("%.2f", tag.measured.range);
    write(drawing, text, {cvRound(middle.x) - 20, cvRound(middle.y) + 4}, kTagText);
  }
  return drawing;
}
}  // namespace mrpt_ext
