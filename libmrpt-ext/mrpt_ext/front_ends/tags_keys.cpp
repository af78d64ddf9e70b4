#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/vision/tags/tag_view.h"

namespace mrpt_ext
{
namespace
{
KeyTable tagCameraKeys()
{
  constexpr ValueRange kDistortion{-100, 100}, kMetres{-100, 100};
  return pinholeKeys(kTagsSection)
      .number("distortion_k1", "", kUnset, kDistortion,
              "Radial distortion, as OpenCV and ROS (plumb_bob) count it. Not set: k1 of camera.json; neither: 0.")
      .number("distortion_k2", "", kUnset, kDistortion, "Not set: k2 of camera.json; neither: 0.")
      .number("distortion_k3", "", kUnset, kDistortion, "Not set: k3 of camera.json; neither: 0.")
      .number("distortion_p1", "", kUnset, kDistortion, "Tangential. Not set: p1 of camera.json; neither: 0.")
      .number("distortion_p2", "", kUnset, kDistortion, "Not set: p2 of camera.json; neither: 0.")
      .number("sensor_x_m", "m", kUnset, kMetres,
              "Forward of the robot's origin. Not set: forward of camera.json; neither: 0.")
      .number("sensor_y_m", "m", kUnset, kMetres,
              "Left of the robot's origin. Not set: left of camera.json; neither: 0.")
      .number("camera_height_m", "m", kUnset, kMetres, "Above the floor. Not set: height_m of camera.json; neither: 0.")
      .number(
          "mount_yaw_deg", "deg", kUnset, {-360, 360},
          "Where the camera looks, from the robot's forward axis. Not set: mount_yaw_deg of camera.json; neither: 0.")
      .number("pitch_deg", "deg", kUnset, {-89, 89},
              "Looking down is positive. Not set: pitch_deg of camera.json; neither: 0.")
      .number("roll_deg", "deg", kUnset, {-180, 180},
              "Positive: the right side is lower. Not set: roll_deg of camera.json; neither: 0.");
}
}  // namespace

KeyTable tagsKeys()
{
  const TagSettings view;
  const TagDetectorSettings detector;
  std::vector<KeyChoice> families;
  for (const std::string& name : tagFamilies()) families.push_back({name, {}, "AprilTag"});
  families.push_back({kArucoOriginal, {}, "the 1024 markers of the first ArUco"});
  KeyTable table =
      KeySection(kTagsSection)
          .text("sensor_label", "", "tags", "Label of the observations.")
          .choice("family", detector.family, families, "Which tags hang in the world.")
          .forBeginners()
          .path("dictionary_file",
                "Tags of another kind, instead of a family: YAML with nmarkers, markersize, marker_0 ...")
          .number(
              "tag_edge_m", "m", kUnset, {0.001, 100},
              "Outer edge of the black border; with a white border (tagStandard, tagCircle) its inner edge. Not set: "
              "tag_edge_m of camera.json.")
          .forBeginners()
          .number("std_corner_px", "px", view.noise.std_corner, {0.01, 100},
                  "Standard deviation of a tag's corner, each way: covariances of bearing and range follow from it.")
          .degrees(
              "std_upright_deg", "deg", view.noise.std_upright, {0.01, 1000},
              "Standard deviation of a tag's upright edges from the vertical, a tilt of the robot included. 90 and "
              "more: tags hang in any attitude, and small ones seem up to a standard deviation too near.")
          .integer("corner_noise_frames", "", 20, {0, 1000},
                   "Frames whose tags tell std_corner_px when they fit squares worse than it states. 0: none.")
          .number("gate", "", view.gate, {1, 100},
                  "Corners that are farther from any square than so many standard deviations are no tag's.")
          .number("decimation", "", detector.decimation, {1, 8},
                  "Tags are searched in an image smaller by this; 1 finds the smallest ones.")
          .integer(
              "corrected_bits", "", detector.corrected_bits, {0, 2},
              "Of a tag's code that may be wrong; fewer where one random code in a thousand would be a tag then, as "
              "of tag16h5 and of ArUco with 4x4 cells.")
          .number("min_margin", "", detector.min_margin, {0, 255},
                  "Least mean contrast of a tag's cells, in 255ths of the brightest light in the image.")
          .flag("linear_camera", detector.linear_camera,
                "Grey levels are proportional to light. Otherwise they are coded for screens (sRGB).");
  return table.append(tagCameraKeys());
}
}  // namespace mrpt_ext
