#include "mrpt_ext/front_ends/images_keys.h"

namespace mrpt_ext
{
namespace
{
KeySpec key(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {"ConicMirror", name, KeyType::number, unit, default_value, range, {}, help};
}

KeySpec whole(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {"ConicMirror", name, KeyType::integer, unit, default_value, range, {}, help};
}
}  // namespace

KeyTable conicMirrorKeys()
{
  constexpr ValueRange kShare{0.01, 1}, kAspect{0.5, 2}, kRadius{0.05, 2};
  return {{
      {"ConicMirror", "sensor_label", KeyType::text, "", "omni", {}, {}, "Label of the observations."},
      whole("image_width", "px", "", {64, 20000}, "Not set: width of camera.json; neither: any."),
      whole("image_height", "px", "", {64, 20000}, "Not set: height of camera.json; neither: any."),
      key("mount_yaw_deg", "deg", "", {-360, 360},
          "Azimuth of the image's u axis in the robot's frame. Not set: mount_yaw_deg of camera.json; neither: 0."),
      key("sensor_x_m", "m", "0", {-100, 100}, "Place of the mirror's axis, forward of the robot's origin."),
      key("sensor_y_m", "m", "0", {-100, 100}, "Place of the mirror's axis, left of the robot's origin."),
      key("principal_u_px", "px", "", {-20000, 20000},
          "Column of the camera's principal point. With the next three it tells how far the mirror's axis stands "
          "beside "
          "the camera's. Not set: cx of camera.json; neither: the axes agree."),
      key("principal_v_px", "px", "", {-20000, 20000}, "Row of the principal point. Not set: cy of camera.json."),
      key("cone_half_angle_deg", "deg", "", {1, 89}, "Of the mirror. Not set: cone_half_angle_deg of camera.json."),
      key("rim_angle_deg", "deg", "", {1, 89},
          "Between the camera's axis and the ray to the mirror's rim. Not set: rim_phi_deg of camera.json."),
      key("rim_radius_min", "", "0.25", kRadius, "Smallest radius of the rim, share of the image's shorter side."),
      key("rim_radius_max", "", "0.75", kRadius, "Largest radius of the rim, share of the image's shorter side."),
      key("rim_aspect_min", "", "0.8", kAspect, "Smallest width over height of the rim (fx/fy of the camera)."),
      key("rim_aspect_max", "", "1.25", kAspect, "Largest width over height of the rim."),
      key("rim_visible_share", "", "0.4", kShare,
          "Share of the rim's circumference that must be found; with less there is no measurement."),
      key("rim_contrast", "", "5", {0.5, 255}, "Grey levels across the rim that count as seeing it."),
      whole("azimuths", "", "1440", {180, 20000}, "Columns of the unrolled ring."),
      whole("radii", "", "96", {8, 4000}, "Rows of the unrolled ring."),
      key("ring_inner", "", "0.15", {0.02, 0.98}, "Where the ring begins, share of the rim's radius."),
      key("ring_outer", "", "0.97", {0.05, 1}, "Where the ring ends."),
      key("edge_smoothing_deg", "deg", "0.4", {0.05, 5}, "Standard deviation of the smoothing along azimuth."),
      key("edge_length", "", "0.18", kShare, "Shortest edge, share of the ring's width."),
      key("edge_significance", "", "8", {1, 1000}, "Least evidence for an edge, in deviations of the image's noise."),
      key("edge_contrast", "", "0.015", {0, 1}, "Least mean step, share of the ring's median brightness."),
      key("edge_width_deg", "deg", "0.61", {0.05, 10},
          "Largest standard deviation of an edge in the room; soft shadows are wider. Smoothing and blur come on top."),
      key("edge_blur_px", "px", "1.05", {0, 20},
          "Standard deviation of what camera and sampling add to an edge's width."),
      key("edge_prominence", "", "0.45", {0, 1}, "How far the step must fall on both sides, share of its peak."),
      key("std_floor_deg", "deg", "0.029", {0, 10}, "Standard deviation of an azimuth that noise does not explain."),
  }};
}
}  // namespace mrpt_ext
