#include "mrpt_ext/vision/slice_profile.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/vision/light_coding.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRowStep = 1;        ///< [px] between the rows that are averaged
constexpr double kBesideEdge = 1.5;   ///< [px] from an edge to where its levels are taken
constexpr double kShareInside = 0.4;  ///< of the half width that is inside in any case
constexpr double kLeastLevel = 1;     ///< black is not zero

/// [px] by which an edge between these levels seems too far on the side of `inside`.
double shiftOfEdge(double inside, double outside)
{
  const double a = std::max(kLeastLevel, inside), b = std::max(kLeastLevel, outside);
  return std::copysign(shiftByCoding(a, b), b - a);
}
}  // namespace

std::optional<cv::Vec3d> levelsAt(const cv::Mat& image, const cv::Point2d& position)
{
  const int u = static_cast<int>(std::floor(position.x)), v = static_cast<int>(std::floor(position.y));
  if (u < 0 || v < 0 || u + 1 >= image.cols || v + 1 >= image.rows) return std::nullopt;
  const auto* upper = image.ptr<cv::Vec3b>(v) + u;
  const auto* lower = image.ptr<cv::Vec3b>(v + 1) + u;
  const double x = position.x - u, y = position.y - v;
  cv::Vec3d levels;
  for (int c = 0; c < 3; ++c)
    levels[c] = (1 - y) * ((1 - x) * upper[0][c] + x * upper[1][c]) + y * ((1 - x) * lower[0][c] + x * lower[1][c]);
  return levels;
}

double SliceProfile::lumaAt(double offset) const
{
  const double at = std::clamp(offset - first, 0.0, static_cast<double>(size()) - 1);
  const auto before = std::min(static_cast<std::size_t>(at), size() - 2);
  const double share = at - static_cast<double>(before);
  return (1 - share) * luma[before] + share * luma[before + 1];
}

std::optional<SliceProfile> profileOf(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth,
                                      const SilhouetteSlice& slice, double reach)
{
  SliceProfile profile;
  const double focal = mirror.focalLength();
  profile.per_pixel = 2 / ((slice.rho_low + slice.rho_high) * focal);
  profile.half_width = slice.half_width / profile.per_pixel;
  const int to_side = static_cast<int>(profile.half_width + reach);
  profile.first = -to_side;
  const int rows = std::max(1, static_cast<int>(std::lround((slice.rho_high - slice.rho_low) * focal / kRowStep)));
  for (int i = -to_side; i <= to_side; ++i)
  {
    const double angle = azimuth + i * profile.per_pixel;
    const cv::Point2d outwards = mirror.pixel(angle, 1) - mirror.centre;
    cv::Vec3d sum(0, 0, 0);
    for (int row = 0; row < rows; ++row)
    {
      const double rho = slice.rho_low + (row + 0.5) / rows * (slice.rho_high - slice.rho_low);
      const auto levels = levelsAt(image, mirror.centre + rho * outwards);
      if (!levels) return std::nullopt;
      sum += *levels / rows;
    }
    profile.luma.push_back(0.114 * sum[0] + 0.587 * sum[1] + 0.299 * sum[2]);
    profile.chroma[0].push_back(0.564 * (sum[0] - profile.luma.back()));
    profile.chroma[1].push_back(0.713 * (sum[2] - profile.luma.back()));
  }
  const double out = profile.half_width + kBesideEdge;
  const double in = std::max(profile.half_width - kBesideEdge, kShareInside * profile.half_width);
  profile.shift_low = shiftOfEdge(profile.lumaAt(-in), profile.lumaAt(-out));
  profile.shift_high = shiftOfEdge(profile.lumaAt(in), profile.lumaAt(out));
  return profile;
}
}  // namespace mrpt_ext
