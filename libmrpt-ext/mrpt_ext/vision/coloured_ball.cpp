#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/field_objects.h"

namespace mrpt_ext
{
namespace
{
/// A patch of one colour in the panorama.
struct Patch
{
  double area = 0;             ///< [pixels]
  double column = 0, row = 0;  ///< centre
};

/// The orange patches; those that touch the seam are seen whole in a panorama repeated by `overlap` columns.
std::vector<Patch> orangePatches(const cv::Mat1b& colours, int overlap, double min_area)
{
  const cv::Mat1b mask(colours == static_cast<int>(ObjectColour::orange));
  cv::Mat1b wide;
  cv::hconcat(mask, mask.colRange(0, overlap), wide);
  const cv::Rect around = cv::boundingRect(wide);
  std::vector<Patch> patches;
  if (around.empty()) return patches;
  cv::Mat labels, figures, centres;
  const int count = cv::connectedComponentsWithStats(wide(around), labels, figures, centres, 8, CV_32S);
  for (int i = 1; i < count; ++i)
    if (const int area = figures.at<int>(i, cv::CC_STAT_AREA); area >= min_area)
      patches.push_back(
          {static_cast<double>(area), centres.at<double>(i, 0) + around.x, centres.at<double>(i, 1) + around.y});
  return patches;
}
}  // namespace

std::vector<ObjectGuess> findBalls(const cv::Mat1b& colours, const MirrorPanorama& panorama,
                                   const HyperbolicMirror& mirror, const FieldObjectSizes& sizes,
                                   const FieldObjectSearch& search)
{
  std::vector<std::pair<double, ObjectGuess>> found;  // with the area
  for (const Patch& patch : orangePatches(colours, colours.cols / 8, search.min_area))
  {
    const double slope = panorama.slope(static_cast<int>(std::lround(patch.row)));
    if (slope >= 0) continue;
    const double drop = mirror.focus_height - sizes.ball_radius;
    const double distance = drop / -slope;
    if (distance < search.min_distance || distance > search.max_distance) continue;
    const double half_width = std::asin(std::min(1.0, sizes.ball_radius / distance));
    const double half_height = std::asin(std::min(1.0, sizes.ball_radius / std::hypot(distance, drop)));
    const double elevation = std::atan(slope);
    const int rows =
        panorama.rowAt(std::tan(elevation - half_height)) - panorama.rowAt(std::tan(elevation + half_height));
    const double area = kPi / 4 * rows * 2 * half_width * panorama.columns() / kTwoPi;
    const double ratio = std::min(patch.area / area, area / patch.area);
    if (ratio < square(1 - search.width_tolerance)) continue;
    found.push_back({patch.area, {panorama.azimuth(patch.column), half_width, distance}});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<ObjectGuess> guesses;
  for (const auto& [area, guess] : found) guesses.push_back(guess);
  return guesses;
}
}  // namespace mrpt_ext
