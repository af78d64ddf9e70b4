#pragma once

#include <vector>

#include "mrpt_ext/vision/radial_edge.h"

namespace mrpt_ext
{
/// What blurs an edge that is sharp in the room.
struct EdgeBlur
{
  double smoothing = 0;  ///< [rad] along azimuth
  double pixels = 0;     ///< [px] standard deviation of the image's blur
  double radius = 0;     ///< [px] of the rim

  /// [rad] standard deviation of the edge's profile at a radius, share of the rim's.
  [[nodiscard]] double widthAt(double share) const;
  /// The same seen with `times` the smoothing.
  [[nodiscard]] EdgeBlur smoothed(double times) const { return {times * smoothing, pixels, radius}; }
};

/// Places every edge at the mean of its parts, weighted by what noise and neighbours leave of them. Edges closer than
/// their profiles are wide move each other: a part is moved back by what the same location of Gaussian profiles makes
/// of both, the whole edge by what more smoothing does to it; shares of both moves are errors. The standard deviation
/// is that of the parts' scatter, the edge's own and that of the image, together with what all parts have in common:
/// the raster of the pixels, `centre_std` [px] of the rim's centre, what clipping may move the edge by, and `floor`
/// [rad]. Every edge must have a part.
void locateByParts(std::vector<RadialEdge>& edges, const EdgeBlur& blur, double centre_std, double floor);
}  // namespace mrpt_ext
