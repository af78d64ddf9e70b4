#pragma once

#include <vector>

#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/vision_front_end.h"
#include "mrpt_ext/solvers/two_pole_pose.h"
#include "mrpt_ext/vision/omni_objects.h"

namespace mrpt_ext
{
/// Poles and ball in the images of up to three omnidirectional cameras M1, M2, M3 as bearings (paper 001, section 2).
class MovisFrontEnd : public VisionFrontEnd
{
 public:
  /// Sizes of cameras, mirrors and field: of the .ini, else of camera.json.
  MovisFrontEnd(const Settings& settings, const CameraFile& camera);

  [[nodiscard]] FrameMeasurements measure(const ImageFrame& frame, bool with_drawings) const override;
  [[nodiscard]] LandmarkTable landmarks() const override;
  [[nodiscard]] std::vector<int> calibrationFrames() const override { return calibration_frames_; }
  /// Estimates the rotation of each camera against its position in the triangle, and corrects for it from then on.
  CalibrationNotes calibrate(const std::vector<FrameAtPose>& frames) override;

 private:
  /// A camera on the robot. Its sensor frame has the robot's axes.
  struct Mounted
  {
    std::string label;
    Vector2d position{0, 0};  ///< [m] in the robot's frame
    double yaw = 0;           ///< [rad] azimuth of the image's u axis in the robot's frame
    OmniCamera camera;
  };

  /// What a camera sees in one frame.
  struct Seen
  {
    const Mounted* mounted = nullptr;
    std::vector<OmniObject> objects;
  };

  [[nodiscard]] double bearingOf(const Mounted& mounted, const OmniObject& object) const;
  /// Removes what the other cameras see elsewhere. Returns how many.
  std::size_t dropContradicted(std::vector<Seen>& frame) const;
  [[nodiscard]] int idOf(const std::string& label) const;

  std::vector<Mounted> cameras_;
  PoleField field_;
  double pole_height_ = 0;
  std::vector<int> pole_ids_, calibration_frames_;
};
}  // namespace mrpt_ext
