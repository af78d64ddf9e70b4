#include "mrpt_ext/front_ends/images_keys.h"

namespace mrpt_ext
{
namespace
{
KeySpec key(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {"Movis", name, KeyType::number, unit, default_value, range, {}, help};
}

KeySpec whole(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {"Movis", name, KeyType::integer, unit, default_value, range, {}, help};
}

KeySpec several(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {"Movis", name, KeyType::numbers, unit, default_value, range, {}, help};
}

constexpr ValueRange kShare{0.001, 1}, kSize{1e-4, 1000}, kLength{1e-3, 100}, kAngle{-360, 360};

std::vector<KeySpec> cameraKeys()
{
  return {
      whole("image_width", "px", "", {64, 20000}, "Not set: width of camera.json; neither: any."),
      whole("image_height", "px", "", {64, 20000}, "Not set: height of camera.json; neither: any."),
      key("mount_radius_m", "m", "", kLength, "From the robot's middle to each mirror. Not set: L of camera.json."),
      several("mount_yaw_deg", "deg", "0 0 0", kAngle, "Known angles by which M1, M2 and M3 are turned on the robot."),
      several("calibration_frame", "", "", {0, 1e9},
              "Numbers of frames whose pose in frames.csv is taken for known: the cameras' angles on the robot are "
              "measured there and taken off everywhere. Not set: no calibration."),
      key("mirror_a_m", "m", "", kSize, "Semi-axis of the hyperbola along the mirror's axis. Not set: a."),
      key("mirror_b_m", "m", "", kSize, "Semi-axis across. Not set: b of camera.json."),
      key("mirror_rim_radius_m", "m", "", kSize, "Radius of the mirror's rim. Not set: rim_radius of camera.json."),
      key("mirror_focus_height_m", "m", "", kLength,
          "Inner focus above the floor. Not set: focus_height of camera.json."),
      key("focal_length_x_px", "px", "", {1, 1e6}, "Not set: fx of camera.json."),
      key("focal_length_y_px", "px", "", {1, 1e6}, "Not set: fy of camera.json."),
      several("centres", "px", "", {-1e5, 1e5}, "cx cy of M1, M2 and M3. Not set: centers of camera.json."),
      key("holder_radius_m", "m", "", kSize,
          "Radius of what a neighbour's mirror and holder hide. Not set: 1.1 times the rim's."),
      key("rim_visible_share", "", "0.4", kShare,
          "Share of the rim that must be darker outside than inside; with less there is no measurement."),
      key("rim_contrast", "", "5", {0.5, 255}, "Grey levels across the rim that count as darker."),
  };
}

std::vector<KeySpec> fieldKeys()
{
  return {
      key("field_half_width_m", "m", "", kLength, "Poles p and q are at -x and x. Not set: Fw of camera.json."),
      key("field_depth_m", "m", "", {-100, 100}, "y of the poles. Not set: Fd of camera.json."),
      key("pole_radius_m", "m", "", kLength, "Not set: pole_radius of camera.json."),
      key("pole_height_m", "m", "", kLength, "Three bands of equal height. Not set: pole_height of camera.json."),
      key("ball_radius_m", "m", "", kLength, "Not set: ball_radius of camera.json."),
      several("pole_ids", "", "1 2", {0, 1e9}, "Ids of the landmarks p and q."),
  };
}

std::vector<KeySpec> colourKeys()
{
  return {
      several("orange_hue_deg", "deg", "-10 33", kAngle,
              "Hues of the ball, in linear light after white balance; red is 0, green 120, blue 240."),
      several("yellow_hue_deg", "deg", "33 80", kAngle, "Hues of the yellow bands."),
      several("blue_hue_deg", "deg", "200 265", kAngle, "Hues of the blue bands."),
      key("min_saturation", "", "0.55", {0, 1}, "Of these colours: 1 - darkest / brightest channel, in linear light."),
      key("min_brightness", "", "0.02", {0, 1}, "Of the brightest channel, share of white in linear light."),
      several("white_rgb", "", "", {1, 255}, "Grey levels of white. Not set: from each image itself."),
      key("white_share", "", "0.03", kShare,
          "Share of the pixels that is taken for white: those whose darkest channel is brightest."),
  };
}

std::vector<KeySpec> searchKeys()
{
  return {
      whole("columns", "", "900", {180, 20000}, "Columns of the panorama in which colours are sought."),
      key("lowest_slope", "", "-1.5", {-20, -0.05}, "Tangent of the elevation where the panorama ends."),
      key("min_distance_m", "m", "0.3", kLength, "Nearest object."),
      key("max_distance_m", "m", "10", kLength, "Farthest object."),
      key("band_share", "", "0.5", kShare, "Share of a band's pixels that must have its colour."),
      key("width_tolerance", "", "0.35", {0.01, 1},
          "How far an object's width may differ from that of its distance, as a share."),
      key("ball_area", "", "6", {1, 1e6}, "Smallest ball in pixels of the panorama."),
      whole("min_slices", "", "3", {1, 1000}, "Slices of two rows of an object whose middles must agree."),
      key("std_floor_deg", "deg", "0.03", {0, 10}, "Standard deviation of an azimuth that its slices have in common."),
  };
}
}  // namespace

KeyTable movisKeys()
{
  std::vector<KeySpec> all = cameraKeys();
  for (const auto& part : {fieldKeys(), colourKeys(), searchKeys()}) all.insert(all.end(), part.begin(), part.end());
  return KeyTable(all);
}
}  // namespace mrpt_ext
