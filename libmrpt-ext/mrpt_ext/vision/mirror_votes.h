#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "mrpt_ext/vision/axis_ellipse.h"
#include "mrpt_ext/vision/outline_settings.h"

namespace mrpt_ext
{
/// Candidates for the mirror's rim, best first, accurate to a few percent of its radius: circles of a reduced image, in
/// full-size pixels. Every pixel with a strong gradient votes along its gradient, in both directions, for the centres
/// within the allowed radii (Kimme, Ballard and Sklansky 1975), in an image stretched by each of several aspect ratios;
/// the radius follows from the gradients that point at the centre.
[[nodiscard]] std::vector<AxisEllipse> voteForMirrors(const cv::Mat& grey, const OutlineSettings& settings);
}  // namespace mrpt_ext
