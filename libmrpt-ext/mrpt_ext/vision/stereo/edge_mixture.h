#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace mrpt_ext
{
/// The linear light of a pixel as coded, up to a factor.
[[nodiscard]] inline cv::Vec3d lightOf(const cv::Vec3d& level) { return level.mul(level); }

/// A pixel at an edge between white and paint sums light of both. Where a goal's side is seen, paint in the shade lies
/// between them: shade takes light and leaves the colour. So a pixel is white and paint in shares that are found by
/// least squares over its channels; that of white does not depend on shade, and what both lack of a whole is dark.
class EdgeMixture
{
 public:
  /// Linear light of both.
  EdgeMixture(const cv::Vec3d& white, const cv::Vec3d& paint)
  {
    const double ww = white.dot(white), pp = paint.dot(paint), wp = white.dot(paint), det = ww * pp - wp * wp;
    tells_dark_ = det > kLeastAngle2 * ww * pp;
    if (!tells_dark_)
    {
      white_ = white / std::max(ww, 1e-12);
      return;
    }
    white_ = (pp * white - wp * paint) / det;
    paint_ = (ww * paint - wp * white) / det;
  }

  [[nodiscard]] double whiteIn(const cv::Vec3d& light) const { return white_.dot(light); }
  /// 0 where white and paint are of one colour, and shade looks like paint.
  [[nodiscard]] double darkIn(const cv::Vec3d& light) const
  {
    return tells_dark_ ? 1 - (white_ + paint_).dot(light) : 0;
  }

 private:
  static constexpr double kLeastAngle2 = 1e-4;  // squared, of two colours [rad^2]

  bool tells_dark_ = false;
  cv::Vec3d white_, paint_;  ///< the share of each is the product with a pixel's light
};
}  // namespace mrpt_ext
