#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "mrpt_ext/vision/field_objects.h"

namespace mrpt_ext
{
/// How far away a banded pole is.
struct PoleDistance
{
  double distance = 0, std = 0;  ///< [m] from the mirror's axis
};

/// From where the colours of neighbouring bands meet in the middle of the pole, which `guess` knows roughly: its height
/// and the mirror tell how far its front is, without a look at the width, of which something may hide a part. Nothing
/// where a boundary is not seen or the boundaries fit no distance.
[[nodiscard]] std::optional<PoleDistance> distanceByBands(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                          const FieldObjectSizes& sizes, const ObjectGuess& guess);

/// True where the upper two bands meet as high as they do on a pole at about this distance; the lower two, where the
/// upper boundary is outside the mirror. Only what is as high hides the upper boundary, which is about as high as the
/// mirror, so that the distance hardly moves it.
[[nodiscard]] bool bandsMeetThere(const cv::Mat& image, const HyperbolicMirror& mirror, const FieldObjectSizes& sizes,
                                  const ObjectGuess& guess);
}  // namespace mrpt_ext
