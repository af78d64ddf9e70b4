#pragma once

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/vision_front_end.h"
#include "mrpt_ext/vision/conic_mirror.h"

namespace mrpt_ext
{
/// Vertical edges of the conic mirror as anonymous bearings (paper 000).
class ConicMirrorFrontEnd : public VisionFrontEnd
{
 public:
  /// Image size and mounting yaw: from the .ini, else from camera.json, else any and 0.
  ConicMirrorFrontEnd(const Settings& settings, const CameraFile& camera);

  [[nodiscard]] FrameMeasurements measure(const ImageFrame& frame, bool with_drawings) const override;
  [[nodiscard]] std::size_t selfCalibrationFrames() const override { return calibration_frames_; }
  CalibrationNotes selfCalibrate(const std::vector<ImageFrame>& frames) override;
  [[nodiscard]] std::map<std::string, double> calibratedNumbers() const override { return calibrated_; }

 private:
  ConicMirrorSettings model_;
  std::size_t calibration_frames_;
  std::map<std::string, double> calibrated_;
  Pose2 T_robot_sensor_;
  std::string label_;
};
}  // namespace mrpt_ext
