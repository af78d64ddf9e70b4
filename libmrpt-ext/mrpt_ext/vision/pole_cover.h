#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "mrpt_ext/vision/field_objects.h"

namespace mrpt_ext
{
/// The part of a pole that nothing hides.
struct PoleCover
{
  double edge = 0;  ///< [rad] azimuth in the image of the edge of what hides the rest
  int side = 0;     ///< of the pole that is hidden: -1 at smaller azimuths, 1 at larger ones
};

/// What stands in front of a pole is nearer, so that it reaches below the pole's foot and has the same colour there as
/// beside the pole; the floor in front of the pole has not. Nothing where neither side is hidden, or both are. `guess`
/// is where the pole's colours are seen.
[[nodiscard]] std::optional<PoleCover> coverOfPole(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                   const FieldObjectSizes& sizes, const ObjectGuess& guess);
}  // namespace mrpt_ext
