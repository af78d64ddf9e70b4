#pragma once

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/vision_front_end.h"
#include "mrpt_ext/vision/stereo/corner_agreement.h"
#include "mrpt_ext/vision/stereo/stereo_goal.h"

namespace mrpt_ext
{
/// Identified goal corners and line landmarks with categories, as ranges and bearings (paper 004).
class StereoGoalFrontEnd : public VisionFrontEnd
{
 public:
  /// The camera's model: of the .ini, else of camera.json. Throws InputError when neither has it.
  StereoGoalFrontEnd(const Settings& settings, const CameraFile& camera);

  [[nodiscard]] FrameMeasurements measure(const ImageFrame& frame, bool with_drawings) const override;
  [[nodiscard]] std::size_t selfCalibrationFrames() const override { return agreement_frames_; }
  /// What must be the same in all frames: rows of the corners' feet and of both images, width of the goals. Tells what
  /// differs from the settings, which stay as they are; corners that do not agree are left out from then on.
  CalibrationNotes selfCalibrate(const std::vector<ImageFrame>& frames) override;

 private:
  struct CornerName
  {
    const char* label;
    int id;
  };
  [[nodiscard]] const CornerName& nameOf(const GoalCorner& corner) const;

  /// Removes the corners that do not agree with the other frames. Returns how many.
  std::size_t dropContradicted(StereoGoalView& view, const cv::Mat& left, const cv::Mat& right) const;

  StereoGoalSettings model_;
  CornerConstants constants_;
  std::optional<double> goal_width_;  ///< [m] as stated
  std::size_t agreement_frames_ = 0;
  Pose2 T_robot_sensor_;
  std::string label_, line_label_;
  std::array<CornerName, 4> names_;  ///< of both corners of the yellow and of the blue goal, left one first
};
}  // namespace mrpt_ext
