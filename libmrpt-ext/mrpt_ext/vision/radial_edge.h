#pragma once

#include <vector>

#include "mrpt_ext/vision/edge_parts.h"

namespace mrpt_ext
{
/// A vertical edge of the room: a radial one in the image.
struct RadialEdge
{
  double azimuth = 0;       ///< [rad] in the image: from the u axis towards the v axis, wrapped
  double width = 0;         ///< [rad] standard deviation of its profile, at least that of smoothing and blur
  double std_azimuth = 0;   ///< [rad]
  int polarity = 0;         ///< +1: brighter towards growing azimuth, -1: darker
  double contrast = 0;      ///< [grey levels] mean step
  double height = 0;        ///< [grey levels] that of the edge alone, without what its neighbours take from it
  double coding_shift = 0;  ///< [px] towards its darker side that its parts have (light_coding.h)
  double std_clipping = 0;  ///< [px] of all its parts together, where a side is too bright for the image
  double significance = 0;
  double inner = 0, outer = 0;  ///< ends, shares of the rim's radius
  std::vector<EdgePart> parts;  ///< those that show it by themselves
  int pair = 0;                 ///< above 0: of two edges that were located together (edge_pair.h)
};
}  // namespace mrpt_ext
