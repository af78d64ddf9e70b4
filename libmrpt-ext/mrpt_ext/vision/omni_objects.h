#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "mrpt_ext/vision/field_objects.h"
#include "mrpt_ext/vision/pole_cover.h"

namespace mrpt_ext
{
/// Azimuths in the image where a part of the robot hides the field: [middle - half_width, middle + half_width].
struct BlockedSector
{
  double middle = 0, half_width = 0;  ///< [rad]
};

/// One of the omnidirectional cameras of paper 001, section 2.
struct OmniCameraSettings
{
  cv::Size image_size;  ///< [px]; empty: any
  HyperbolicMirror mirror;
  FieldObjectSizes sizes;
  ColourModel colours;
  FieldObjectSearch search;
  std::vector<BlockedSector> blocked;
  int columns = 900;               ///< of the panorama
  double lowest_slope = -1.5;      ///< of the panorama
  double rim_visible_share = 0.4;  ///< of the rim that must be darker outside than inside
  double rim_contrast = 5;         ///< [grey levels] that count as darker
  int min_slices = 3;              ///< slices of an object that must agree
  double std_floor = 0;            ///< [rad] standard deviation of an azimuth that its slices have in common
};

/// A pole or the ball in one image.
struct OmniObject
{
  std::string label;       ///< "p" (yellow, blue, yellow), "q" (blue, yellow, blue) or "ball"
  double azimuth = 0;      ///< [rad] in the image
  double std_azimuth = 0;  ///< [rad]
  double half_width = 0;   ///< [rad] as seen
  double distance = 0;  ///< [m] from the mirror's axis, by its size and position: rough, for drawings and checks only
};

/// What one image shows.
struct OmniView
{
  std::string problem;  ///< why there is no measurement; empty when there may be some
  std::vector<OmniObject> objects;
  std::vector<OmniObject> hidden;  ///< behind a blocked sector: seen in part, not measured
  cv::Vec3d white{0, 0, 0};        ///< linear BGR taken for white
};

/// A camera with the tables made for it.
class OmniCamera
{
 public:
  explicit OmniCamera(OmniCameraSettings settings)
      : settings_(std::move(settings)), panorama_(settings_.mirror, settings_.columns, settings_.lowest_slope)
  {
  }

  /// Poles and ball. A wrong, empty, grey or black image and one without the mirror have a problem and no objects.
  [[nodiscard]] OmniView view(const cv::Mat& image) const;
  /// The image with the rim, the blocked sectors and what was found, with azimuths [deg] in the frame in which the u
  /// axis has `yaw` [rad].
  [[nodiscard]] cv::Mat draw(const cv::Mat& image, const OmniView& view, double yaw = 0) const;
  [[nodiscard]] const OmniCameraSettings& settings() const { return settings_; }

 private:
  /// Adds the object to the view; false when it is not where it was guessed.
  bool measure(const cv::Mat& image, const std::string& label, const ObjectGuess& guess, OmniView& view) const;
  /// The same for a pole of which one side is hidden.
  bool measureCovered(const cv::Mat& image, const std::string& label, const ObjectGuess& guess, const PoleCover& cover,
                      OmniView& view) const;

  OmniCameraSettings settings_;
  MirrorPanorama panorama_;
};
}  // namespace mrpt_ext
