#include "mrpt_ext/vision/silhouette.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/vision/object_colours.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSampleStep = 0.5;       ///< [px] between samples
constexpr double kEdgeReach = 2;          ///< [px] from an edge, where blur has ended
constexpr double kBackground = 6;         ///< [px] from an edge, where the background is taken from
constexpr double kMinAngleSquare = 0.01;  ///< squared sine of the angle between two colours that can be distinguished
constexpr double kOutlier = 3;            ///< standard deviations
constexpr double kAgreement = 0.15;       ///< [px] by which slices may differ in any case, as standard deviation
constexpr double kChroma = 0.5;           ///< of its precision that colour has: JPEG and sensors have few pixels of it
constexpr int kRecentring = 2;

using Profile = std::vector<cv::Vec3d>;

/// Mixtures are the same mixtures; least squares over them trust brightness more.
cv::Vec3d withLessChroma(const cv::Vec3d& light)
{
  const double luminance = light.dot(cv::Vec3d(0.114, 0.587, 0.299));
  return cv::Vec3d::all((1 - kChroma) * luminance) + kChroma * light;
}

/// Mean light of a slice outwards from the middle, on the side given by `sign`; sample i is (i + 1/2) `step` away.
std::optional<Profile> profileOf(const cv::Mat& image, const HyperbolicMirror& mirror, double middle, int sign,
                                 const SilhouetteSlice& slice, double step, int samples)
{
  const double length = (slice.rho_high - slice.rho_low) * mirror.focalLength();
  const int rows = std::max(1, static_cast<int>(std::lround(length / kSampleStep)));
  Profile profile(static_cast<std::size_t>(samples), cv::Vec3d(0, 0, 0));
  for (int row = 0; row < rows; ++row)
  {
    const double rho = slice.rho_low + (row + 0.5) / rows * (slice.rho_high - slice.rho_low);
    for (int i = 0; i < samples; ++i)
    {
      const auto light = lightAt(image, mirror.pixel(middle + sign * (i + 0.5) * step, rho));
      if (!light) return std::nullopt;
      profile[static_cast<std::size_t>(i)] += withLessChroma(*light) / rows;
    }
  }
  return profile;
}

cv::Vec3d meanOf(const Profile& profile, int first, int end)
{
  cv::Vec3d sum(0, 0, 0);
  for (int i = first; i < end; ++i) sum += profile[static_cast<std::size_t>(i)];
  return sum / std::max(1, end - first);
}

/// Where an object ends on one side.
struct Edge
{
  double offset = 0;    ///< [rad] from the middle, > 0
  double variance = 0;  ///< of relative size only
};

/// From one side's profile: how far the object reaches. Background share of each sample by least squares with free
/// brightness of the object.
std::optional<Edge> edgeOf(const Profile& profile, double half_width, double step, double per_pixel)
{
  const int samples = static_cast<int>(profile.size());
  const int inner_end = std::max(1, static_cast<int>(0.6 * half_width / step));
  const int outer = static_cast<int>((half_width + kEdgeReach * per_pixel) / step);
  if (outer >= samples) return std::nullopt;
  const cv::Vec3d object = meanOf(profile, 0, inner_end), background = meanOf(profile, outer, samples);
  const double oo = object.dot(object), bb = background.dot(background), ob = object.dot(background);
  const double determinant = oo * bb - ob * ob;
  if (determinant < kMinAngleSquare * oo * bb || oo <= 0 || bb <= 0) return std::nullopt;
  double inside = 0;
  for (const cv::Vec3d& light : profile)
    inside += 1 - (oo * background.dot(light) - ob * object.dot(light)) / determinant;
  return Edge{inside * step, oo / determinant};
}

/// The result of one slice.
struct SliceResult
{
  double offset = 0;       ///< [rad] of its middle from the guess
  double width_ratio = 1;  ///< of what was seen to what was expected
  double weight = 0;
  double per_pixel = 0;  ///< [rad]
};

std::optional<SliceResult> measureSlice(const cv::Mat& image, const HyperbolicMirror& mirror, double middle,
                                        const SilhouetteSlice& slice)
{
  const double per_pixel = 1 / (0.5 * (slice.rho_low + slice.rho_high) * mirror.focalLength());  // [rad]
  const double step = kSampleStep * per_pixel;
  const int samples = static_cast<int>((slice.half_width + kBackground * per_pixel) / step);
  double offset = 0;
  std::optional<SliceResult> result;
  for (int round = 0; round < kRecentring; ++round)
  {
    result.reset();
    const auto left = profileOf(image, mirror, middle + offset, -1, slice, step, samples);
    const auto right = profileOf(image, mirror, middle + offset, 1, slice, step, samples);
    if (!left || !right) return std::nullopt;
    const auto low = edgeOf(*left, slice.half_width, step, per_pixel);
    const auto high = edgeOf(*right, slice.half_width, step, per_pixel);
    if (!low || !high) return std::nullopt;
    offset += 0.5 * (high->offset - low->offset);
    if (std::abs(offset) > slice.half_width + kEdgeReach * per_pixel) return std::nullopt;
    const double pixels = (slice.rho_high - slice.rho_low) * mirror.focalLength() / per_pixel;
    result = SliceResult{offset, 0.5 * (low->offset + high->offset) / slice.half_width,
                         pixels / (per_pixel * (low->variance + high->variance)), per_pixel};
  }
  return result;
}

/// Keeps the results whose `value` is near the median of all.
template <typename Value>
void dropOutliers(std::vector<SliceResult>& results, double floor, const Value& value)
{
  std::vector<double> values;
  for (const SliceResult& r : results) values.push_back(value(r));
  if (values.empty()) return;
  const double centre = upperMedian(values);
  for (double& v : values) v = std::abs(v - centre);
  const double limit = kOutlier * std::max(1.4826 * upperMedian(values), floor);
  std::erase_if(results, [&](const SliceResult& r) { return std::abs(value(r) - centre) > limit; });
}
}  // namespace

std::optional<Silhouette> measureSilhouette(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth,
                                            const std::vector<SilhouetteSlice>& slices, int min_slices)
{
  std::vector<SliceResult> results;
  for (const SilhouetteSlice& slice : slices)
    if (const auto result = measureSlice(image, mirror, azimuth, slice)) results.push_back(*result);
  if (results.empty()) return std::nullopt;
  const double floor = kAgreement * results.front().per_pixel;
  dropOutliers(results, floor / slices.front().half_width, [](const SliceResult& r) { return r.width_ratio; });
  dropOutliers(results, floor, [](const SliceResult& r) { return r.offset; });
  if (static_cast<int>(results.size()) < min_slices) return std::nullopt;
  double weights = 0, offset = 0, width = 0, scatter = 0;
  for (const SliceResult& r : results)
  {
    weights += r.weight;
    offset += r.weight * r.offset;
    width += r.weight * r.width_ratio;
  }
  offset /= weights;
  for (const SliceResult& r : results) scatter += r.weight * square(r.offset - offset);
  const auto count = static_cast<double>(results.size());
  Silhouette found;
  found.azimuth = wrap(azimuth + offset);
  found.std_azimuth = std::sqrt(scatter / weights / std::max(1.0, count - 1));
  found.width_ratio = width / weights;
  found.slices = static_cast<int>(results.size());
  return found;
}
}  // namespace mrpt_ext
