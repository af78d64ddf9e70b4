#pragma once

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/observations/mrpt_compatibility.h"

namespace mrpt_ext
{
/// Adds the landmarks to a 3-D scene: a ball, the id (or the category, where there is no id) beside it, and an ellipse
/// of three standard deviations where the position is uncertain.
void addLandmarks(scenes::CSetOfObjects& scene, const LandmarkTable& landmarks);
}  // namespace mrpt_ext
