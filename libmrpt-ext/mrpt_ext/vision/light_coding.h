#pragma once

namespace mrpt_ext
{
/// [px] by which an edge between two coded grey levels seems to stand on its darker side, 0 to 0.2. A pixel on the edge
/// sums light, and the camera codes the sum by a power of 1/2.2, as grey levels are made for screens; half way between
/// the levels is then less than half of the light. Levels above zero, in any order.
[[nodiscard]] double shiftByCoding(double level, double other);

/// Where a side of an edge is brighter than the image shows, the part of the step that is shown is the one on the
/// darker side: the mean of a Gaussian that is cut off there. In standard deviations of the camera's blur, from the
/// edge towards its darker side of this grey level; how much brighter the side is, is not known, and taken for usual.
[[nodiscard]] double shiftByClipping(double dark_level);
}  // namespace mrpt_ext
