#pragma once

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/vision_front_end.h"
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

 private:
  struct CornerName
  {
    const char* label;
    int id;
  };
  [[nodiscard]] const CornerName& nameOf(const GoalCorner& corner) const;

  StereoGoalSettings model_;
  Pose2 T_robot_sensor_;
  std::string label_, line_label_;
  std::array<CornerName, 4> names_;  ///< of both corners of the yellow and of the blue goal, left one first
};
}  // namespace mrpt_ext
