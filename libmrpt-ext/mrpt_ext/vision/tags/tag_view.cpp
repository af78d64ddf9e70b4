#include "mrpt_ext/vision/tags/tag_view.h"

#include <cmath>
#include <opencv2/core.hpp>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/image_check.h"

namespace mrpt_ext
{
namespace
{
/// Bearing and range, or why there is none.
void measureInto(TagView& view, const DetectedTag& tag, const TagSettings& settings)
{
  const auto measured = measureTag(tag.corners, settings.edge, settings.camera, settings.noise);
  if (!measured)
    view.refused.push_back({tag.id, "its corners show no square with a bearing"});
  else if (measured->residual > square(settings.gate))
    view.refused.push_back({tag.id, "its corners are not those of an upright square"});
  else
    view.tags.push_back({tag.id, tag.corners, *measured});
}
}  // namespace

TagView viewTags(const cv::Mat& image, const TagDetector& detector, const TagSettings& settings)
{
  TagView view;
  view.problem = complaintAboutImage(image, settings.camera.size);
  if (!view.problem.empty()) return view;
  const cv::Mat grey = greyOf(image);
  double darkest = 0, brightest = 0;
  cv::minMaxLoc(grey, &darkest, &brightest);
  if (darkest == brightest) view.problem = "image is black or of one colour";
  if (!view.problem.empty()) return view;
  const std::vector<DetectedTag> found = detector.detect(grey);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const bool again = i > 0 && found[i - 1].id == found[i].id;
    const bool once_more = i + 1 < found.size() && found[i + 1].id == found[i].id;
    if (!again && !once_more)
      measureInto(view, found[i], settings);
    else if (!again)
      view.refused.push_back({found[i].id, "it is seen more than once"});
  }
  return view;
}
}  // namespace mrpt_ext
