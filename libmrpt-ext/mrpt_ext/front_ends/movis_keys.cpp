#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
namespace
{
constexpr ValueRange kShare{0.001, 1}, kSize{1e-4, 1000}, kLength{1e-3, 100}, kAngle{-360, 360};

KeyTable movisCameraKeys()
{
  return KeySection(kMovisSection)
      .integer("image_width", "px", kUnset, {64, 20000}, "Not set: width of camera.json; neither: any.")
      .integer("image_height", "px", kUnset, {64, 20000}, "Not set: height of camera.json; neither: any.")
      .number("mount_radius_m", "m", kUnset, kLength,
              "From the robot's middle to each mirror. Not set: L of camera.json.")
      .numbers("mount_yaw_deg", "deg", {0, 0, 0}, kAngle,
               "Known angles by which M1, M2 and M3 are turned on the robot.")
      .numbers("calibration_frame", "", {}, {0, 1e9},
               "Numbers of frames whose pose in frames.csv is taken for known: the cameras' angles on the robot are "
               "measured there and taken off everywhere. Not set: no calibration.")
      .number("mirror_a_m", "m", kUnset, kSize, "Semi-axis of the hyperbola along the mirror's axis. Not set: a.")
      .number("mirror_b_m", "m", kUnset, kSize, "Semi-axis across. Not set: b of camera.json.")
      .number("mirror_rim_radius_m", "m", kUnset, kSize,
              "Radius of the mirror's rim. Not set: rim_radius of camera.json.")
      .number("mirror_focus_height_m", "m", kUnset, kLength,
              "Inner focus above the floor. Not set: focus_height of camera.json.")
      .number("focal_length_x_px", "px", kUnset, {1, 1e6}, "Not set: fx of camera.json.")
      .number("focal_length_y_px", "px", kUnset, {1, 1e6}, "Not set: fy of camera.json.")
      .numbers("centres", "px", {}, {-1e5, 1e5}, "cx cy of M1, M2 and M3. Not set: centers of camera.json.")
      .number("holder_radius_m", "m", kUnset, kSize,
              "Radius of what a neighbour's mirror and holder hide. Not set: 1.1 times the rim's.")
      .number("rim_visible_share", "", 0.4, kShare,
              "Share of the rim that must be darker outside than inside; with less there is no measurement.")
      .number("rim_contrast", "", 5, {0.5, 255}, "Grey levels across the rim that count as darker.");
}

KeyTable fieldKeys()
{
  return KeySection(kMovisSection)
      .number("field_half_width_m", "m", kUnset, kLength, "Poles p and q are at -x and x. Not set: Fw of camera.json.")
      .number("field_depth_m", "m", kUnset, {-100, 100}, "y of the poles. Not set: Fd of camera.json.")
      .number("pole_radius_m", "m", kUnset, kLength, "Not set: pole_radius of camera.json.")
      .number("pole_height_m", "m", kUnset, kLength,
              "Three bands of equal height. Not set: pole_height of camera.json.")
      .number("ball_radius_m", "m", kUnset, kLength, "Not set: ball_radius of camera.json.")
      .numbers("pole_ids", "", {1, 2}, {0, 1e9}, "Ids of the landmarks p and q.");
}

KeyTable colourKeys()
{
  return KeySection(kMovisSection)
      .numbers("orange_hue_deg", "deg", {-10, 33}, kAngle,
               "Hues of the ball, in linear light after white balance; red is 0, green 120, blue 240.")
      .numbers("yellow_hue_deg", "deg", {33, 80}, kAngle, "Hues of the yellow bands.")
      .numbers("blue_hue_deg", "deg", {200, 265}, kAngle, "Hues of the blue bands.")
      .number("min_saturation", "", 0.55, {0, 1}, "Of these colours: 1 - darkest / brightest channel, in linear light.")
      .number("min_brightness", "", 0.02, {0, 1}, "Of the brightest channel, share of white in linear light.")
      .numbers("white_rgb", "", {}, {1, 255}, "Grey levels of white. Not set: from each image itself.")
      .number("white_share", "", 0.03, kShare,
              "Share of the pixels that is taken for white: those whose darkest channel is brightest.");
}

KeyTable searchKeys()
{
  return KeySection(kMovisSection)
      .integer("columns", "", 900, {180, 20000}, "Columns of the panorama in which colours are sought.")
      .number("lowest_slope", "", -1.5, {-20, -0.05}, "Tangent of the elevation where the panorama ends.")
      .number("min_distance_m", "m", 0.3, kLength, "Nearest object.")
      .number("max_distance_m", "m", 10, kLength, "Farthest object.")
      .number("band_share", "", 0.5, kShare, "Share of a band's pixels that must have its colour.")
      .number("width_tolerance", "", 0.35, {0.01, 1},
              "How far an object's width may differ from that of its distance, as a share.")
      .number("ball_area", "", 6, {1, 1e6}, "Smallest ball in pixels of the panorama.")
      .integer("min_slices", "", 3, {1, 1000}, "Slices of two rows of an object whose middles must agree.")
      .number("std_floor_deg", "deg", 0, {0, 10}, "Standard deviation of an azimuth that its slices have in common.");
}
}  // namespace

KeyTable movisKeys() { return movisCameraKeys().append(fieldKeys()).append(colourKeys()).append(searchKeys()); }
}  // namespace mrpt_ext
