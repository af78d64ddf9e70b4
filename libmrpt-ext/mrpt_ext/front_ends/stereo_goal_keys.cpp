#include "mrpt_ext/front_ends/images_keys.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kSection = "StereoGoal";

KeySpec key(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {kSection, name, KeyType::number, unit, default_value, range, {}, help};
}

KeySpec whole(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {kSection, name, KeyType::integer, unit, default_value, range, {}, help};
}

KeyTable cameraKeys()
{
  constexpr ValueRange kLength{1e-4, 100}, kPixels{1, 1e5};
  return {{
      whole("image_width", "px", "", {64, 20000}, "Not set: width of camera.json."),
      whole("image_height", "px", "", {64, 20000}, "Not set: height of camera.json."),
      key("focal_u_px", "px", "", kPixels, "Not set: fx of camera.json."),
      key("focal_v_px", "px", "", kPixels, "Not set: fy of camera.json."),
      key("centre_u_px", "px", "", {-1e5, 1e5}, "Not set: cx of camera.json."),
      key("centre_v_px", "px", "", {-1e5, 1e5}, "Not set: cy of camera.json."),
      key("baseline_m", "m", "", kLength, "From the left to the right camera. Not set: baseline of camera.json."),
      key("camera_height_m", "m", "", kLength, "Above the floor. Not set: height_m of camera.json."),
      key("pitch_deg", "deg", "", {-60, 60}, "Looking down is positive. Not set: pitch_deg of camera.json."),
      key("sensor_x_m", "m", "", {-100, 100}, "Forward of the robot's origin. Not set: forward of camera.json."),
      key("sensor_y_m", "m", "", {-100, 100},
          "Of the left camera, left of the robot's origin. Not set: left of camera.json; neither: half the baseline."),
  }};
}

KeyTable goalKeys()
{
  constexpr ValueRange kShare{0.01, 1.3}, kId{0, 1e6};
  return {{
      whole("scan_step", "px", "4", {1, 16}, "Every such pixel of every such row is looked at; 1 is a full scan."),
      key("goal_height_m", "m", "0.05", {0.001, 10}, "What is not as high where it stands is no goal."),
      key("goal_depth_m", "m", "0.15", {0, 10}, "From the goal line to the goal's back."),
      key("goal_height_tolerance", "", "0.25", {0.01, 0.9}, "Share of the goal's height."),
      key("min_range_m", "m", "0.15", {0.01, 100}, "Nearest depth of a corner."),
      key("max_range_m", "m", "2.2", {0.02, 1000}, "Farthest depth of a corner."),
      whole("min_rows", "px", "5", {2, 1000}, "Rows in which both images must show the corner."),
      key("std_column_px", "px", "0.15", {0, 10}, "Deviation of a corner's column that noise does not explain."),
      key("std_disparity_px", "px", "0.12", {0, 10},
          "Likewise of its disparity; both images share much of the former."),
      key("yellow_red", "", "1.0", kShare, "Yellow goal beside white: share of the white's red as coded."),
      key("yellow_green", "", "0.9", kShare, "Share of the white's green."),
      key("yellow_blue", "", "0.22", kShare, "Share of the white's blue."),
      key("blue_red", "", "0.22", kShare, "Blue goal beside white: share of the white's red as coded."),
      key("blue_green", "", "0.37", kShare, "Share of the white's green."),
      key("blue_blue", "", "0.85", kShare, "Share of the white's blue."),
      whole("blue_l_id", "", "1", kId, "Landmark of the blue goal's left corner, seen from the field."),
      whole("blue_r_id", "", "2", kId, "Landmark of the blue goal's right corner."),
      whole("yellow_r_id", "", "3", kId, "Landmark of the yellow goal's right corner."),
      whole("yellow_l_id", "", "4", kId, "Landmark of the yellow goal's left corner."),
  }};
}

KeyTable lineKeys()
{
  return {{
      key("line_width_m", "m", "0.003", {1e-4, 1}, "Of the field's markings."),
      key("line_max_range_m", "m", "0.7", {0.05, 100}, "Farthest markings; beyond it they are too thin."),
      key("line_contrast", "", "0.15", {0.01, 1}, "Markings against the floor, share of the image's white."),
      key("line_significance", "", "5", {1, 100}, "Markings against the floor, in deviations of the image's noise."),
      key("wall_contrast", "", "0.4", {0.01, 1}, "Walls against the floor, share of the image's white."),
      key("wall_height_m", "m", "0.05", {0.001, 10}, "What is bright over less than half of it is no wall."),
      key("std_line_px", "px", "0.3", {0.01, 10}, "Deviation of a marking's middle line that its points do not tell."),
  }};
}
}  // namespace

KeyTable stereoGoalKeys()
{
  KeyTable table({
      {kSection, "sensor_label", KeyType::text, "", "stereo", {}, {}, "Label of the goal corners' observations."},
      {kSection, "line_label", KeyType::text, "", "stereo_lines", {}, {}, "Label of the line landmarks' observations."},
      {kSection,
       "features",
       KeyType::choice,
       "",
       "both",
       {},
       {{"corners", {}}, {"lines", {}}, {"both", {}}},
       "Goal corners, junctions of the field's markings, or both."},
      {kSection,
       "disparity",
       KeyType::choice,
       "",
       "sub_pixel",
       {},
       {{"sub_pixel", {}}, {"whole_pixels", {}}},
       "whole_pixels is paper 004's."},
  });
  return table.append(cameraKeys()).append(goalKeys()).append(lineKeys());
}
}  // namespace mrpt_ext
