#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/drawing.h"
#include "mrpt_ext/vision/omni_objects.h"

namespace mrpt_ext
{
namespace
{
const cv::Scalar kRim(0, 200, 255), kFound(255, 255, 255), kHidden(60, 60, 255), kBlocked(160, 160, 160);

void drawRay(cv::Mat& drawing, const HyperbolicMirror& mirror, double azimuth, const cv::Scalar& colour, double from)
{
  cv::line(drawing, fixedPoint(mirror.pixel(azimuth, from * mirror.rimRho())),
           fixedPoint(mirror.pixel(azimuth, mirror.rimRho())), colour, 1, cv::LINE_AA, kFractionBits);
}

/// `position` of the text, share of the rim's radius.
void drawObject(cv::Mat& drawing, const HyperbolicMirror& mirror, const OmniObject& object, const cv::Scalar& colour,
                double position, double yaw)
{
  drawRay(drawing, mirror, object.azimuth, colour, position + 0.05);
  for (const double side : {-1.0, 1.0})
    drawRay(drawing, mirror, object.azimuth + side * object.half_width, colour, 0.6);
  const cv::Point2d text = mirror.pixel(object.azimuth, position * mirror.rimRho());
  write(drawing, object.label + " " + std::to_string(cvRound(radToDeg(wrap(object.azimuth + yaw)))),
        {cvRound(text.x) - 15, cvRound(text.y)}, colour);
}
}  // namespace

cv::Mat OmniCamera::draw(const cv::Mat& image, const OmniView& view, double yaw) const
{
  if (image.empty() || image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) return {};
  cv::Mat drawing = coloured(image);
  const HyperbolicMirror& mirror = settings_.mirror;
  cv::ellipse(drawing, fixedPoint(mirror.centre),
              fixedPoint({mirror.fx * mirror.rimRho(), mirror.fy * mirror.rimRho()}), 0, 0, 360, kRim, 1, cv::LINE_AA,
              kFractionBits);
  for (const BlockedSector& sector : settings_.blocked)
    for (const double side : {-1.0, 1.0})
      drawRay(drawing, mirror, sector.middle + side * sector.half_width, kBlocked, 0.9);
  // Texts at different radii do not cover each other when objects are close.
  double position = 0.1;
  for (const OmniObject& object : view.objects) drawObject(drawing, mirror, object, kFound, position += 0.08, yaw);
  for (const OmniObject& object : view.hidden) drawObject(drawing, mirror, object, kHidden, position += 0.08, yaw);
  if (!view.problem.empty()) write(drawing, view.problem, {10, 20}, kHidden);
  return drawing;
}
}  // namespace mrpt_ext
