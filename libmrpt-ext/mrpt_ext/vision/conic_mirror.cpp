#include "mrpt_ext/vision/conic_mirror.h"

#include "mrpt_ext/vision/image_check.h"

namespace mrpt_ext
{
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
  view.edges = findRadialEdges(unroll(grey, rim, settings.grid, settings.axis), view.outline->std_centre, rim.semi_v,
                               settings.edges);
  return view;
}
}  // namespace mrpt_ext
