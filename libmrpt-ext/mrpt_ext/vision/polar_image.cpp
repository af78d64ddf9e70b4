#include "mrpt_ext/vision/polar_image.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
double PolarGrid::azimuthStep() const { return kTwoPi / azimuths; }

double PolarGrid::radiusOf(double row) const { return inner + (outer - inner) * row / std::max(1, radii - 1); }

PolarImage unroll(const cv::Mat& grey, const AxisEllipse& rim, const PolarGrid& grid,
                  const std::optional<MirrorAxis>& axis)
{
  std::vector<float> cosines(static_cast<std::size_t>(grid.azimuths)), sines(cosines.size());
  for (std::size_t j = 0; j < cosines.size(); ++j)
  {
    cosines[j] = static_cast<float>(rim.semi_u * std::cos(static_cast<double>(j) * grid.azimuthStep()));
    sines[j] = static_cast<float>(rim.semi_v * std::sin(static_cast<double>(j) * grid.azimuthStep()));
  }
  const float last_u = static_cast<float>(grey.cols - 1), last_v = static_cast<float>(grey.rows - 1);
  cv::Mat u(grid.radii, grid.azimuths, CV_32F), v(u.size(), CV_32F);
  PolarImage polar{grid, {}, cv::Mat(u.size(), CV_8U)};
  for (int row = 0; row < grid.radii; ++row)
  {
    const float radius = static_cast<float>(grid.radiusOf(row));
    const cv::Point2f centre = centreOfAzimuths(rim, axis, grid.radiusOf(row));
    float* const us = u.ptr<float>(row);
    float* const vs = v.ptr<float>(row);
    uchar* const inside = polar.inside.ptr<uchar>(row);
    for (std::size_t j = 0; j < cosines.size(); ++j)
    {
      us[j] = centre.x + radius * cosines[j];
      vs[j] = centre.y + radius * sines[j];
      inside[j] = us[j] >= 0 && vs[j] >= 0 && us[j] <= last_u && vs[j] <= last_v ? 255 : 0;
    }
  }
  // A pixel's worth of smoothing: rows are about two pixels apart.
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, {3, 3}, 0.7);
  smooth.convertTo(smooth, CV_32F);
  cv::remap(smooth, polar.grey, u, v, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return polar;
}
}  // namespace mrpt_ext
