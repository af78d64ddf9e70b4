#pragma once

#include <vector>

#include "mrpt_ext/vision/edge_parts.h"
#include "mrpt_ext/vision/polar_image.h"

namespace mrpt_ext
{
/// When a radial step of brightness counts as an edge.
struct RadialEdgeSettings
{
  double smoothing = 0.0070;     ///< [rad] standard deviation of the smoothing along azimuth
  double min_length = 0.18;      ///< radial length, share of the sampled ring
  double min_significance = 8;   ///< evidence of the whole edge, in standard deviations of the noise
  double min_contrast = 0.015;   ///< mean step, share of the ring's median brightness
  double max_width = 0.0107;     ///< [rad] standard deviation of a soft edge in the room, as an exact camera sees it
  double blur = 1.05;            ///< [px] least standard deviation of what camera and sampling add to an edge's width
  double min_prominence = 0.45;  ///< how far the profile falls on both sides, share of the peak
  double std_floor = 0.0005;     ///< [rad] beyond the effect of noise
};

/// A vertical edge of the room: a radial one in the image.
struct RadialEdge
{
  double azimuth = 0;      ///< [rad] in the image: from the u axis towards the v axis, wrapped
  double width = 0;        ///< [rad] standard deviation of its profile, at least that of smoothing and blur
  double std_azimuth = 0;  ///< [rad]
  int polarity = 0;        ///< +1: brighter towards growing azimuth, -1: darker
  double contrast = 0;     ///< [grey levels] mean step
  double significance = 0;
  double inner = 0, outer = 0;  ///< ends, shares of the rim's radius
  std::vector<EdgePart> parts;  ///< those that show it by themselves
};

/// Radial edges of both polarities by voting along radii (paper 000, section 4): at every azimuth each radius votes
/// with its smoothed step of brightness in units of its row's noise, clipped so that none outvotes many; the run of
/// radii with most evidence counts, so that edges that end at a table's height are found. Peaks of the evidence are
/// located to a fraction of a column on the summed steps of the run.
///
/// Edges closer than their profiles are wide pull at each other's peaks; they are moved back by what Gaussian profiles
/// tell, and half of the move is an error of azimuth. So is `centre_std` [px] of the rim's centre at `radius` [px], the
/// rim's. Ordered by azimuth. Noise and blur are those of the image itself, so neither needs a setting: the noise is
/// the median of the steps, the blur what the sharpest of the clear edges show, so that soft shadows remain wider than
/// edges.
[[nodiscard]] std::vector<RadialEdge> findRadialEdges(const PolarImage& polar, double centre_std, double radius,
                                                      const RadialEdgeSettings& settings);
}  // namespace mrpt_ext
