#pragma once

#include <vector>

#include "mrpt_ext/vision/polar_image.h"
#include "mrpt_ext/vision/radial_edge.h"

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
  double std_floor = 0;          ///< [rad] standard deviation beyond what the image itself shows
};

/// Radial edges of both polarities by voting along radii (paper 000, section 4): at every azimuth each radius votes
/// with its smoothed step of brightness in units of its row's noise, clipped so that none outvotes many; the run of
/// radii with most evidence counts, so that edges that end at a table's height are found. Peaks of the evidence are
/// located to a fraction of a column on the summed steps of the run.
///
/// Every edge is then placed by its parts (edge_location.h), with `centre_std` [px] of the rim's centre as an error of
/// azimuth; `radius` [px] is the rim's. Ordered by azimuth. Noise and blur are those of the image itself, so neither
/// needs a setting: the noise is the median of the steps, the blur what the sharpest of the clear edges show, so that
/// soft shadows remain wider than edges.
[[nodiscard]] std::vector<RadialEdge> findRadialEdges(const PolarImage& polar, double centre_std, double radius,
                                                      const RadialEdgeSettings& settings);
}  // namespace mrpt_ext
