#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// One image of a frame; `pixels` is empty when the file is missing, damaged or too large.
struct FrameImage
{
  std::string role;  ///< "image", "left" and "right", or "M1", "M2", "M3"
  std::string name;  ///< for messages and for the names of debug pictures
  cv::Mat pixels;    ///< 8 bits, grey or BGR
  Pose2 T_robot_camera;
  std::string problem = {};  ///< why there are no pixels, where that is known

  /// What is wrong with the image, else what its view complains about; empty when nothing is.
  [[nodiscard]] std::string complaint(const std::string& of_view) const { return problem.empty() ? of_view : problem; }
};

/// Images taken at one time.
struct ImageFrame
{
  int number = 0;
  double time = 0;  ///< [s]
  std::vector<FrameImage> images;

  /// Null when there is none of this role.
  [[nodiscard]] const FrameImage* find(const std::string& role) const;
  /// For messages: its file, or frame and role when the table names no file.
  [[nodiscard]] std::string nameOf(const FrameImage& image) const;
};

using ImageRecord = std::variant<OdometryRecord, ImageFrame>;

/// Images and odometry in the order of time, read one by one.
class ImageSequence
{
 public:
  virtual ~ImageSequence() = default;
  /// Nothing at the end.
  [[nodiscard]] virtual std::optional<ImageRecord> next() = 0;

  CameraFile camera;        ///< what comes with the images
  LandmarkTable map;        ///< empty when none comes with the images
  Trajectory truth;         ///< likewise
  std::size_t ignored = 0;  ///< records that are neither images nor odometry
};

/// A folder with `frames.csv` (one row per frame: `frame`, a file name per role, optional `t`, optional
/// `odometry_x_m,odometry_y_m,odometry_heading_deg`, optional truth `x_m,y_m,heading_deg`), optional `camera.json` and
/// optional `map.csv` (`id,name,x_m,y_m`, optional `category` and `yaw_deg`). Without a role's column, files are found
/// as
/// *_POINT_ROLE.* by the column `point`; a role without any file is left out. `heading_offset` [rad] is added to all
/// headings: what the forward axis is turned against the axis that frames.csv counts from. Throws InputError (data) on
/// damaged tables.
[[nodiscard]] std::unique_ptr<ImageSequence> openImageFolder(const std::filesystem::path& folder,
                                                             const std::vector<std::string>& roles,
                                                             double heading_offset = 0);

/// A rawlog with CObservationImage (its label as the role when it is one of `roles`, else "image"; a frame each) or
/// CObservationStereoImages ("left" and "right") and odometry.
[[nodiscard]] std::unique_ptr<ImageSequence> openImageRawlog(const std::filesystem::path& rawlog,
                                                             const std::vector<std::string>& roles);
}  // namespace mrpt_ext
