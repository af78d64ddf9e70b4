#include "mrpt_ext/vision/mirror_panorama.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRimMargin = 1.5;  ///< [px] the rim itself mixes the mirror with what is behind it
}

MirrorPanorama::MirrorPanorama(const HyperbolicMirror& mirror, int columns, double lowest_slope) : columns_(columns)
{
  const double step = 1 / mirror.focalLength();
  const double inner = mirror.rhoAt(lowest_slope);
  std::vector<double> radii;
  for (double rho = mirror.rimRho() - kRimMargin * step; rho >= inner; rho -= step)
  {
    radii.push_back(rho);
    slopes_.push_back(mirror.slopeAt(rho));
  }
  if (radii.empty()) return;
  cv::Mat map(rows(), columns, CV_32FC2);
  for (int row = 0; row < rows(); ++row)
    for (int column = 0; column < columns; ++column)
      map.at<cv::Vec2f>(row, column) = cv::Point2f(mirror.pixel(azimuth(column), radii[static_cast<std::size_t>(row)]));
  cv::convertMaps(map, cv::noArray(), places_, fractions_, CV_16SC2);
}

cv::Mat MirrorPanorama::unroll(const cv::Mat& image) const
{
  cv::Mat panorama;
  cv::remap(image, panorama, places_, fractions_, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return panorama;
}

double MirrorPanorama::azimuth(double column) const { return wrap(kTwoPi * column / columns_); }

int MirrorPanorama::rowAt(double slope) const
{
  const auto first = std::lower_bound(slopes_.begin(), slopes_.end(), slope, std::greater<>());
  return static_cast<int>(first - slopes_.begin());
}
}  // namespace mrpt_ext
