#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/front_ends/image_frame.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/settings/key_table.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// One measurement as `--csv` tells it.
struct MeasurementRow
{
  std::string sensor, label;
  std::optional<double> azimuth, std_azimuth;  ///< [rad] CCW from robot forward, seen from the sensor's own place
  std::optional<double> range, std_range;      ///< [m]
  std::optional<double> u_left, u_right;       ///< [px]
};

/// A picture of what was found.
struct DebugImage
{
  std::string name;  ///< of the file, without folder and ending
  cv::Mat pixels;
};

/// What one frame gave.
struct FrameMeasurements
{
  std::vector<std::string> problems;  ///< images that could not be used, "NAME: why"
  std::vector<Reading> readings;
  std::vector<MeasurementRow> rows;
  std::vector<DebugImage> drawings;  ///< only when asked for
};

/// A frame taken where the robot's pose is known.
struct FrameAtPose
{
  ImageFrame frame;
  Pose2 robot;
};

/// A sensor's way from images to observations. The work is done by free functions of `vision`; an implementation names
/// the images it needs and puts what they return into our observation types.
class VisionFrontEnd
{
 public:
  virtual ~VisionFrontEnd() = default;
  [[nodiscard]] virtual FrameMeasurements measure(const ImageFrame& frame, bool with_drawings) const = 0;
  /// The landmarks that the settings themselves tell of, for images that come without a map.
  [[nodiscard]] virtual LandmarkTable landmarks() const { return {}; }
  /// Numbers of the frames that `calibrate` wants; none: it is not called.
  [[nodiscard]] virtual std::vector<int> calibrationFrames() const { return {}; }
  /// Learns from frames at known poses, before any other is measured; returns what to tell the user, in lines.
  virtual std::vector<std::string> calibrate(const std::vector<FrameAtPose>& /*frames*/) { return {}; }
};

/// The columns of frames.csv that name the images the configured sensor needs.
[[nodiscard]] std::vector<std::string> imageRoles(const Settings& settings);

/// What the configured sensor's forward axis is turned against the axis that headings in frames.csv count from [rad].
[[nodiscard]] double headingOffset(const Settings& settings);

/// The front end of the configured sensor; `camera` is the object of camera.json or null.
[[nodiscard]] std::unique_ptr<VisionFrontEnd> makeFrontEnd(const Settings& settings, const nlohmann::json& camera);
}  // namespace mrpt_ext
