#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "mrpt_ext/vision/tags/tag_detector.h"
#include "mrpt_ext/vision/tags/tag_measurement.h"

namespace mrpt_ext
{
/// One camera and the tags that it looks for.
struct TagSettings
{
  PinholeCamera camera;
  double edge = 0;  ///< [m] of the square whose corners are found: the outer edge of the black border
  TagNoise noise;
  double gate = 5;  ///< corners farther than so many standard deviations from any square are no tag's
  TagDetectorSettings detector;
};

struct SeenTag
{
  int id = 0;
  TagCorners corners;
  TagMeasurement measured;
};

/// A tag that was found and is not measured.
struct RefusedTag
{
  int id = 0;
  std::string why;
};

/// What one image shows.
struct TagView
{
  std::string problem;        ///< why there is no measurement; empty when there may be some
  std::vector<SeenTag> tags;  ///< in ascending order of ids
  std::vector<RefusedTag> refused;
};

/// The tags of an image. A wrong, empty or black image has a problem and no tags. Two with one id are both refused: one
/// of them is not the map's.
[[nodiscard]] TagView viewTags(const cv::Mat& image, const TagDetector& detector, const TagSettings& settings);

/// The image in colour with the tags, their ids and ranges [m].
[[nodiscard]] cv::Mat drawTags(const cv::Mat& image, const TagView& view);
}  // namespace mrpt_ext
