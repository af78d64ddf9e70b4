#pragma once

#include <vector>

#include "mrpt_ext/vision/stereo/floor_lines.h"

namespace mrpt_ext
{
/// Where markings meet: two that end, one that ends at another or at a wall, two that cross.
enum class JunctionKind
{
  corner,
  tee,
  crossing
};

/// "L", "T" or "X".
[[nodiscard]] const char* nameOf(JunctionKind kind);

struct FloorJunction
{
  JunctionKind kind = JunctionKind::corner;
  Eigen::Vector2d position{0, 0};  ///< [m] (forward, left) of the camera's foot
  cv::Point2d pixel;
  double std_u = 0;      ///< [px] of the pixel's column
  bool complete = true;  ///< false: some possible arms are outside the image
};

/// Intermediate results, for drawings.
struct FloorMarkings
{
  MarkingPoints points;
  std::vector<FloorLine> stripes, walls;
  std::vector<FloorJunction> junctions;
};

/// Junctions of markings. Lines that would meet at more than a right angle's third are fitted again to the points near
/// their meeting, so that arcs have their tangents there; then the existing ones of the four arms are counted. An arm
/// is there when points follow it, bent at most like the field's circle; with an arm that is neither there nor missing
/// nothing is reported. Markings at a wall's foot are junctions as well.
[[nodiscard]] FloorMarkings findFloorJunctions(const cv::Mat& whiteness, const StereoCamera& camera,
                                               const MarkingSettings& settings);
}  // namespace mrpt_ext
