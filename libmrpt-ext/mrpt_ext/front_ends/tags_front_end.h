#pragma once

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/vision_front_end.h"
#include "mrpt_ext/vision/tags/tag_view.h"

namespace mrpt_ext
{
/// Fiducial tags (AprilTag, ArUco) in one camera: bearings and ranges to their centres, identified by the tags'
/// numbers.
class TagsFrontEnd : public VisionFrontEnd
{
 public:
  /// The camera's model: of the .ini, else of camera.json. Throws InputError when neither has it.
  TagsFrontEnd(const Settings& settings, const CameraFile& camera);

  [[nodiscard]] FrameMeasurements measure(const ImageFrame& frame, bool with_drawings) const override;
  [[nodiscard]] std::size_t selfCalibrationFrames() const override { return noise_frames_; }
  /// How precise the corners are shows in how well squares fit them; what is stated is the least.
  CalibrationNotes selfCalibrate(const std::vector<ImageFrame>& frames) override;

 private:
  TagSettings model_;
  TagDetector detector_;
  std::size_t noise_frames_;
  Pose2 T_robot_sensor_;
  double height_;  ///< [m] above the floor
  std::string label_;
};
}  // namespace mrpt_ext
