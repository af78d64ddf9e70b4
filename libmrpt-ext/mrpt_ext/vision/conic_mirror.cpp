#include "mrpt_ext/vision/conic_mirror.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/vision/image_check.h"

namespace mrpt_ext
{
namespace
{
std::string textOf(const cv::Point2d& pixel)
{
  return std::to_string(std::lround(pixel.x)) + " " + std::to_string(std::lround(pixel.y)) + " px";
}

/// [rad] standard deviation of azimuths about the camera's axis, where the mirror sees from beside it: a mirror's
/// radius is a hundredth of the distances in a room.
double parallaxOf(const AxisEllipse& rim, const std::optional<MirrorAxis>& axis)
{
  constexpr double kMirrorOverRoom = 0.01;
  return axis ? kMirrorOverRoom * cv::norm(mirrorOffset(rim, *axis)) / rim.semi_v / std::sqrt(2.0) : 0;
}

/// The same circle: a mirror of which a part is hidden is found with some pixels of error.
bool isSameRim(const AxisEllipse& a, const AxisEllipse& b)
{
  constexpr double kSameRim = 0.03;  // of the radius
  return cv::norm(a.centre - b.centre) < kSameRim * b.semi_v && std::abs(a.semi_v - b.semi_v) < kSameRim * b.semi_v;
}
}  // namespace

std::optional<AxisEllipse> usualRimOf(const std::vector<cv::Mat>& images, const ConicMirrorSettings& settings)
{
  constexpr std::ptrdiff_t kLeastImages = 3;
  std::vector<AxisEllipse> rims;
  for (const cv::Mat& image : images)
    if (const ConicMirrorView view = viewConicMirror(image, settings); view.problem.empty())
      rims.push_back(view.outline->rim);
  for (const AxisEllipse& rim : rims)
  {
    const auto same =
        std::count_if(rims.begin(), rims.end(), [&](const AxisEllipse& other) { return isSameRim(other, rim); });
    if (same >= kLeastImages && 2 * same > static_cast<std::ptrdiff_t>(rims.size())) return rim;
  }
  return std::nullopt;
}

ConicMirrorView viewConicMirror(const cv::Mat& image, const ConicMirrorSettings& settings)
{
  ConicMirrorView view;
  view.axis = settings.axis;
  view.problem = complaintAboutImage(image, settings.image_size);
  if (!view.problem.empty()) return view;
  const cv::Mat grey = greyOf(image);
  view.outline = findMirrorOutline(grey, settings.outline);
  if (!view.outline)
  {
    view.problem = "no mirror found";
    return view;
  }
  const AxisEllipse& rim = view.outline->rim;
  if (const auto& rival = view.outline->rival)
  {
    view.contradicts = true;
    view.problem = "two circles may be the mirror, about " + textOf(rim.centre) + " and " + textOf(rival->centre);
    return view;
  }
  if (settings.usual_rim && !isSameRim(rim, *settings.usual_rim))
  {
    view.contradicts = true;
    view.problem = "mirror found about " + textOf(rim.centre) + ", in other images about " +
                   textOf(settings.usual_rim->centre) + ": something else was taken for its rim";
    return view;
  }
  RadialEdgeSettings edges = settings.edges;
  edges.std_floor = std::hypot(edges.std_floor, parallaxOf(rim, settings.axis));
  view.edges =
      findRadialEdges(unroll(grey, rim, settings.grid, settings.axis), view.outline->std_centre, rim.semi_v, edges);
  return view;
}
}  // namespace mrpt_ext
