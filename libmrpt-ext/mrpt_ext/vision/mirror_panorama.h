#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "mrpt_ext/vision/hyperbolic_mirror.h"

namespace mrpt_ext
{
/// Unrolls the images of one mirror: columns are azimuths, rows are image radii from the rim (top) inwards. The
/// tables are made once per camera.
class MirrorPanorama
{
 public:
  MirrorPanorama() = default;
  /// Rows reach down to `lowest_slope`, about one row per pixel of the image.
  MirrorPanorama(const HyperbolicMirror& mirror, int columns, double lowest_slope);

  [[nodiscard]] cv::Mat unroll(const cv::Mat& image) const;
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return static_cast<int>(slopes_.size()); }
  /// [rad] of a column's centre, which may be a fraction.
  [[nodiscard]] double azimuth(double column) const;
  /// Slope of a row's centre, descending with the row.
  [[nodiscard]] double slope(int row) const { return slopes_[static_cast<std::size_t>(row)]; }
  /// First row at or below the slope; `rows()` when there is none.
  [[nodiscard]] int rowAt(double slope) const;

 private:
  int columns_ = 0;
  std::vector<double> slopes_;
  cv::Mat places_, fractions_;  // OpenCV's fixed-point form of the map
};
}  // namespace mrpt_ext
