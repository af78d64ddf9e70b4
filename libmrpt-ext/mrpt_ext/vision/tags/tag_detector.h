#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "mrpt_ext/vision/tags/tag_dictionary.h"
#include "mrpt_ext/vision/tags/tag_pose.h"

namespace mrpt_ext
{
struct TagDetectorSettings
{
  std::string family = "tag36h11";  ///< one of tagFamilies()
  TagDictionary dictionary;         ///< instead of a family when it has codes
  double decimation = 1.5;          ///< quads are searched in an image smaller by this
  int corrected_bits = 1;      ///< of a tag's code, at most 2; fewer in dictionaries that would take noise for tags
  double min_margin = 20;      ///< mean contrast of the cells [grey levels of light]; less is no tag
  bool linear_camera = false;  ///< grey levels are light; else it is coded for screens (sRGB)
};

/// A tag that was found.
struct DetectedTag
{
  int id = 0;
  TagCorners corners;
};

/// AprilTag's families by name, most usual first.
[[nodiscard]] std::vector<std::string> tagFamilies();

/// The detector of the AprilTag library (Wang, Olson, "AprilTag 2", 2016). An edge between black and white that is
/// summed in light and coded for screens seems to stand up to 0.2 px within the black; so it sees light, not grey
/// levels. One thread at a time.
class TagDetector
{
 public:
  explicit TagDetector(const TagDetectorSettings& settings);
  ~TagDetector();

  /// In ascending order of ids, several with one id where it is seen several times; of an 8-bit grey image.
  [[nodiscard]] std::vector<DetectedTag> detect(const cv::Mat& grey) const;

 private:
  struct Library;
  TagDetectorSettings settings_;
  std::unique_ptr<Library> library_;
};
}  // namespace mrpt_ext
