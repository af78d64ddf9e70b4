#pragma once

#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/front_ends/image_frame.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// A row of `--csv`.
struct MeasurementRow
{
  std::string sensor, label;
  std::optional<double> azimuth, std_azimuth;  ///< [rad] CCW from robot forward, seen from the sensor's own position
  std::optional<double> range, std_range;      ///< [m]
  std::optional<double> u_left, u_right;       ///< [px]
  std::optional<Facing> facing;                ///< of what is seen, from robot forward

  MeasurementRow(const std::string& sensor_label, const std::string& name, const Detection& detection)
      : sensor(sensor_label), label(name), azimuth(detection.bearing), range(detection.range), facing(detection.facing)
  {
    if (azimuth) std_azimuth = detection.std_bearing;
    if (range) std_range = detection.std_range;
  }
};

/// An image with the detected features drawn in.
struct DebugImage
{
  std::string name;  ///< of the file, without folder and ending
  cv::Mat pixels;
};

/// The measurements of one frame.
struct FrameMeasurements
{
  std::vector<std::string> problems;  ///< images that could not be used, "NAME: why"
  std::vector<Reading> readings;
  std::vector<MeasurementRow> rows;
  std::vector<DebugImage> drawings;  ///< only on request
  std::size_t contradicted = 0;      ///< measurements or images left out because others contradict them
};

/// A frame taken where the robot's pose is known.
struct FrameAtPose
{
  ImageFrame frame;
  Pose2 robot;
};

/// What a calibration tells the user.
struct CalibrationNotes
{
  std::vector<std::string> results;
  std::vector<std::string> warnings;  ///< what stays uncalibrated, and why
};

/// From the images of one sensor to readings. The work is done by free functions of `vision`; an implementation names
/// the images it needs and turns the results into readings.
class VisionFrontEnd
{
 public:
  virtual ~VisionFrontEnd() = default;
  [[nodiscard]] virtual FrameMeasurements measure(const ImageFrame& frame, bool with_drawings) const = 0;
  /// The landmarks that the settings state, for images that come without a map.
  [[nodiscard]] virtual LandmarkTable landmarks() const { return {}; }
  /// Numbers of the frames that `calibrate` needs; none: it is not called.
  [[nodiscard]] virtual std::vector<int> calibrationFrames() const { return {}; }
  /// Calibrates on frames at known poses, before any other is measured.
  virtual CalibrationNotes calibrate(const std::vector<FrameAtPose>& /*frames*/) { return {}; }
  /// How many frames `selfCalibrate` wants; none: it is not called.
  [[nodiscard]] virtual std::size_t selfCalibrationFrames() const { return 0; }
  /// Estimates constants of the sensor from the first frames, wherever they were taken, before any is measured.
  virtual CalibrationNotes selfCalibrate(const std::vector<ImageFrame>& /*frames*/) { return {}; }
  /// What self-calibration changed, under the names of camera.json; empty: nothing.
  [[nodiscard]] virtual std::map<std::string, double> calibratedNumbers() const { return {}; }
};
}  // namespace mrpt_ext
