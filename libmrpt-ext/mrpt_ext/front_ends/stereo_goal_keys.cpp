#include "mrpt_ext/front_ends/images_keys.h"

namespace mrpt_ext
{
namespace
{

KeyTable cameraKeys()
{
  constexpr ValueRange kCameraLength{1e-4, 100};
  return pinholeKeys(kStereoGoalSection)
      .number("baseline_m", "m", kUnset, kCameraLength,
              "From the left to the right camera. Not set: baseline of camera.json.")
      .number("camera_height_m", "m", kUnset, kCameraLength, "Above the floor. Not set: height_m of camera.json.")
      .number("pitch_deg", "deg", kUnset, {-60, 60}, "Looking down is positive. Not set: pitch_deg of camera.json.")
      .number("sensor_x_m", "m", kUnset, {-100, 100}, "Forward of the robot's origin. Not set: forward of camera.json.")
      .number(
          "sensor_y_m", "m", kUnset, {-100, 100},
          "Of the left camera, left of the robot's origin. Not set: left of camera.json; neither: half the baseline.");
}

KeyTable goalKeys()
{
  constexpr ValueRange kColourShare{0.01, 1.3}, kId{0, 1e6};
  return KeySection(kStereoGoalSection)
      .integer("scan_step", "px", 4, {1, 16}, "Every such pixel of every such row is examined; 1 is a full scan.")
      .number("goal_height_m", "m", 0.05, {0.001, 10}, "What is not as high where it stands is no goal.")
      .number("goal_depth_m", "m", 0.15, {0, 10}, "From the goal line to the goal's back.")
      .number("goal_width_m", "m", kUnset, {0.001, 100},
              "Between both corners of a goal. Not set: goal_width of the field in camera.json; neither: any.")
      .integer("agreement_frames", "", 60, {0, 100000},
               "Frames that tell what is the same in all: the row of a corner's foot at its range, both images' rows, "
               "a goal's width. Corners that do not agree are left out. 0: not tested.")
      .number("goal_height_tolerance", "", 0.25, {0.01, 0.9}, "Share of the goal's height.")
      .number("min_range_m", "m", 0.15, {0.01, 100}, "Nearest depth of a corner.")
      .number("max_range_m", "m", 2.2, {0.02, 1000}, "Farthest depth of a corner.")
      .integer("min_rows", "px", 5, {2, 1000}, "Rows in which both images must show the corner.")
      .number("std_column_px", "px", 0.15, {0, 10},
              "Standard deviation of a corner's column that noise does not explain.")
      .number("std_disparity_px", "px", 0.08, {0, 10},
              "Likewise of its disparity; both images share much of the former.")
      .number("yellow_red", "", 1.0, kColourShare, "Yellow goal beside white: share of the white's red as coded.")
      .number("yellow_green", "", 0.9, kColourShare, "Share of the white's green.")
      .number("yellow_blue", "", 0.22, kColourShare, "Share of the white's blue.")
      .number("blue_red", "", 0.22, kColourShare, "Blue goal beside white: share of the white's red as coded.")
      .number("blue_green", "", 0.37, kColourShare, "Share of the white's green.")
      .number("blue_blue", "", 0.85, kColourShare, "Share of the white's blue.")
      .integer("blue_l_id", "", 1, kId, "Landmark of the blue goal's left corner, seen from the field.")
      .integer("blue_r_id", "", 2, kId, "Landmark of the blue goal's right corner.")
      .integer("yellow_r_id", "", 3, kId, "Landmark of the yellow goal's right corner.")
      .integer("yellow_l_id", "", 4, kId, "Landmark of the yellow goal's left corner.");
}

KeyTable lineKeys()
{
  return KeySection(kStereoGoalSection)
      .number("line_width_m", "m", 0.003, {1e-4, 1}, "Of the field's markings.")
      .number("line_max_range_m", "m", 0.7, {0.05, 100}, "Farthest markings; beyond it they are too thin.")
      .number("line_contrast", "", 0.15, {0.01, 1}, "Markings against the floor, share of the image's white.")
      .number("line_significance", "", 5, {1, 100},
              "Markings against the floor, in standard deviations of the image's noise.")
      .number("wall_contrast", "", 0.4, {0.01, 1}, "Walls against the floor, share of the image's white.")
      .number("wall_height_m", "m", 0.05, {0.001, 10}, "What is bright over less than half of it is no wall.")
      .number("std_line_px", "px", 0.3, {0.01, 10},
              "Standard deviation of a marking's centre line that its points do not show.");
}
}  // namespace

KeyTable stereoGoalKeys()
{
  KeyTable table =
      KeySection(kStereoGoalSection)
          .text("sensor_label", "", "stereo", "Label of the goal corners' observations.")
          .text("line_label", "", "stereo_lines", "Label of the line landmarks' observations.")
          .choice("features", "both",
                  {{"corners", {}, "goal corners"}, {"lines", {}, "junctions of the field's markings"}, {"both"}},
                  "Landmarks to measure.")
          .choice("disparity", "sub_pixel", {{"sub_pixel"}, {"whole_pixels", {}, "as in paper 004"}},
                  "Resolution of disparities.");
  return table.append(cameraKeys()).append(goalKeys()).append(lineKeys());
}
}  // namespace mrpt_ext
