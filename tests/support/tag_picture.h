#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/tags/tag_dictionary.h"
#include "mrpt_ext/vision/tags/tag_pose.h"

// Square tags, placed before a camera and painted by summing light over each pixel.
namespace mrpt_ext::testing
{
/// 640 x 480 pixels, looking up by 9 deg.
inline PinholeCamera wallCamera()
{
  PinholeCamera camera;
  camera.size = {640, 480};
  camera.fx = camera.fy = 440;
  camera.cx = 319.5, camera.cy = 239.5;
  camera.pitch = degToRad(-9);
  return camera;
}

/// Where an upright tag is, seen from the camera in level axes.
struct PlacedTag
{
  double range = 2;     ///< [m] horizontal
  double bearing = 0;   ///< [rad]
  double above = 0.3;   ///< [m] of the camera
  double turned = 0.3;  ///< [rad] off the line of sight
  double edge = 0.2;    ///< [m]

  /// Clockwise as one sees them who stands before the tag, from its upper left one.
  [[nodiscard]] TagCorners corners(const PinholeCamera& camera) const
  {
    const double facing = bearing + turned;
    const Eigen::Vector3d centre(range * std::cos(bearing), range * std::sin(bearing), above);
    const Eigen::Vector3d right(std::sin(facing), -std::cos(facing), 0), up(0, 0, 1);
    TagCorners corners;
    const std::array<Eigen::Vector3d, 4> arms{up - right, up + right, right - up, -right - up};
    for (std::size_t i = 0; i < corners.size(); ++i)
      corners[i] = camera.project(camera.levelAxes().transpose() * (centre + 0.5 * edge * arms[i])).value().pixel;
    return corners;
  }
};

struct PaintedTag
{
  int id = 0;
  TagCorners corners;  ///< as those of a PlacedTag
};

/// Tags with a white margin on a grey wall, straight lines between their corners; coded for screens.
inline cv::Mat paintTags(const cv::Size& size, const TagDictionary& dictionary, const std::vector<PaintedTag>& tags)
{
  constexpr int kSamples = 8;
  constexpr double kWall = 0.4, kBlack = 0.04, kMargin = 0.8;
  cv::Mat light(size, CV_64F, cv::Scalar(kWall));
  const int n = dictionary.cells;
  for (const PaintedTag& tag : tags)
  {
    // Cells from the upper left corner of the border, which is one cell wide, as the margin around it is.
    const auto far = static_cast<float>(n + 2);
    const cv::Point2f cells[4] = {{0, 0}, {far, 0}, {far, far}, {0, far}};
    cv::Point2f pixels[4];
    for (int i = 0; i < 4; ++i) pixels[i] = cv::Point2d(tag.corners[i].x(), tag.corners[i].y());
    const cv::Matx33d warp = cv::getPerspectiveTransform(pixels, cells);
    const auto lightAt = [&](double u, double v, double behind)
    {
      const cv::Vec3d at = warp * cv::Vec3d(u, v, 1);
      const double column = at[0] / at[2], row = at[1] / at[2];
      if (column < -1 || column >= n + 3 || row < -1 || row >= n + 3) return behind;
      if (column < 0 || column >= n + 2 || row < 0 || row >= n + 2) return kMargin;
      const int cell = (static_cast<int>(row) - 1) * n + static_cast<int>(column) - 1;
      if (column < 1 || column >= n + 1 || row < 1 || row >= n + 1) return kBlack;
      return dictionary.codes[tag.id] >> (n * n - 1 - cell) & 1 ? kMargin : kBlack;
    };
    cv::Rect box = cv::boundingRect(std::vector<cv::Point2f>(pixels, pixels + 4));
    box = cv::Rect(box.x - box.width / 2, box.y - box.height / 2, 2 * box.width, 2 * box.height) & cv::Rect({}, size);
    for (int v = box.y; v < box.y + box.height; ++v)
      for (int u = box.x; u < box.x + box.width; ++u)
      {
        double sum = 0;
        for (int k = 0; k < kSamples * kSamples; ++k)
          sum += lightAt(u - 0.5 + (k % kSamples + 0.5) / kSamples, v - 0.5 + (k / kSamples + 0.5) / kSamples,
                         light.at<double>(v, u));
        light.at<double>(v, u) = sum / (kSamples * kSamples);
      }
  }
  cv::Mat image;
  cv::pow(light, 1 / 2.2, light);
  light.convertTo(image, CV_8U, 255);
  return image;
}
}  // namespace mrpt_ext::testing
