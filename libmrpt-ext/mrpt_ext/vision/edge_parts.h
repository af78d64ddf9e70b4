#pragma once

#include <vector>

#include "mrpt_ext/vision/radial_peaks.h"

namespace mrpt_ext
{
constexpr double kMoreSmoothing = 1.5;

/// Where a part of an edge is: a few neighbouring rows of its run.
struct EdgePart
{
  double radius = 0;       ///< share of the rim's
  double azimuth = 0;      ///< [rad] in the image, wrapped
  double std_azimuth = 0;  ///< [rad] by noise
  /// [rad] by which it moves when it is smoothed `kMoreSmoothing` times as much: what is beside the edge pulls at it.
  double drift = 0;
  double spacing = 0;       ///< [rad] of the samples that it was located by (radial_peaks.h)
  double soft_spacing = 0;  ///< [rad] likewise with more smoothing; 0 where no drift was measured
};

/// The peak's run in parts of equal numbers of rows, from the centre outwards, for steps smoothed by `smoothing`
/// columns. A part that does not show the edge by itself is left out.
[[nodiscard]] std::vector<EdgePart> partsOf(const RadialPeak& peak, const AzimuthSteps& steps, const PolarGrid& grid,
                                            double smoothing);
}  // namespace mrpt_ext
