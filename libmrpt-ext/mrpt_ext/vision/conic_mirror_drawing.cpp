#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/conic_mirror.h"
#include "mrpt_ext/vision/drawing.h"

namespace mrpt_ext
{
namespace
{
const cv::Scalar kRimColour(0, 200, 255), kBrighter(80, 220, 80), kDarker(255, 120, 60), kText(60, 60, 255);
}  // namespace

cv::Mat drawConicMirror(const cv::Mat& image, const ConicMirrorView& view, double yaw)
{
  if (image.empty() || image.depth() != CV_8U) return {};
  cv::Mat drawing = coloured(image);
  if (!view.outline)
  {
    write(drawing, view.problem, {10, 24}, kText, 0.6);
    return drawing;
  }
  for (const cv::Point2d& p : view.outline->support)
    cv::circle(drawing, fixedPoint(p), 1 << kFractionBits, kRimColour, cv::FILLED, cv::LINE_AA, kFractionBits);
  const AxisEllipse& rim = view.outline->rim;
  cv::drawMarker(drawing, {cvRound(rim.centre.x), cvRound(rim.centre.y)}, kRimColour, cv::MARKER_CROSS, 11);
  for (const RadialEdge& edge : view.edges)
  {
    const cv::Point2d direction(std::cos(edge.azimuth), std::sin(edge.azimuth));
    const auto at = [&](double share)
    { return fixedPoint(rim.at(direction, share) - rim.centre + centreOfAzimuths(rim, view.axis, share)); };
    cv::line(drawing, at(edge.inner), at(edge.outer), edge.polarity > 0 ? kBrighter : kDarker, 1, cv::LINE_AA,
             kFractionBits);
    const std::string text = std::to_string(cvRound(radToDeg(wrap(edge.azimuth + yaw))));
    const cv::Point2d position = rim.at(direction, 1.04);
    write(drawing, text, {cvRound(position.x) - 10, cvRound(position.y) + 4}, kText, 0.35);
  }
  return drawing;
}
}  // namespace mrpt_ext
