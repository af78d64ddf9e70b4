#pragma once

#include <opencv2/core/mat.hpp>

#include "mrpt_ext/vision/axis_ellipse.h"
#include "mrpt_ext/vision/mirror_axis.h"

namespace mrpt_ext
{
/// How finely the ring between two circles around the mirror's axis is sampled.
struct PolarGrid
{
  int azimuths = 1440;  ///< columns, of a full turn
  int radii = 96;       ///< rows
  double inner = 0.15;  ///< radius of the first row, share of the rim's
  double outer = 0.97;  ///< radius of the last row

  [[nodiscard]] double azimuthStep() const;         ///< [rad] per column
  [[nodiscard]] double radiusOf(double row) const;  ///< share of the rim's radius
};

/// The ring unrolled: row k at radius grid.radiusOf(k), column j at the azimuth j * azimuthStep() around the centre
/// of azimuths at this radius (mirror_axis.h), measured on the undistorted circle; CV_32F grey levels. What is
/// outside the image repeats its border; `inside` is 0 there and 255 elsewhere.
struct PolarImage
{
  PolarGrid grid;
  cv::Mat grey;    ///< CV_32F
  cv::Mat inside;  ///< CV_8U
};

[[nodiscard]] PolarImage unroll(const cv::Mat& grey, const AxisEllipse& rim, const PolarGrid& grid,
                                const std::optional<MirrorAxis>& axis = std::nullopt);

/// The column that `column` is across the seam of a panorama.
[[nodiscard]] inline int wrappedColumn(int column, int columns) { return ((column % columns) + columns) % columns; }
}  // namespace mrpt_ext
