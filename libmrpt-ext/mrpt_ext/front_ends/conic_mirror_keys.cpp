#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
KeyTable conicMirrorKeys()
{
  constexpr ValueRange kShare{0.01, 1}, kAspect{0.5, 2}, kRadius{0.05, 2};
  return KeySection(kConicMirrorSection)
      .text("sensor_label", "", "omni", "Label of the observations.")
      .integer("image_width", "px", kUnset, {64, 20000}, "Not set: width of camera.json; neither: any.")
      .integer("image_height", "px", kUnset, {64, 20000}, "Not set: height of camera.json; neither: any.")
      .number("mount_yaw_deg", "deg", kUnset, {-360, 360},
              "Azimuth of the image's u axis in the robot's frame. Not set: mount_yaw_deg of camera.json; neither: 0.")
      .number("sensor_x_m", "m", 0, {-100, 100}, "Position of the mirror's axis, forward of the robot's origin.")
      .number("sensor_y_m", "m", 0, {-100, 100}, "Position of the mirror's axis, left of the robot's origin.")
      .number("principal_u_px", "px", kUnset, {-20000, 20000},
              "Column of the camera's principal point. With the next three it gives the offset of the mirror's axis "
              "from the camera's. Not set: cx of camera.json; neither: the axes agree.")
      .number("principal_v_px", "px", kUnset, {-20000, 20000},
              "Row of the principal point. Not set: cy of camera.json.")
      .number("cone_half_angle_deg", "deg", kUnset, {1, 89},
              "Of the mirror. Not set: cone_half_angle_deg of camera.json.")
      .number("rim_angle_deg", "deg", kUnset, {1, 89},
              "Between the camera's axis and the ray to the mirror's rim. Not set: rim_phi_deg of camera.json.")
      .number("camera_tilt_u_deg", "deg", kUnset, {-20, 20},
              "Direction of the mirror's axis seen from the camera's, towards the image's u axis. Not set: "
              "camera_tilt_u_deg of camera.json; neither: 0.")
      .number("camera_tilt_v_deg", "deg", kUnset, {-20, 20}, "The same towards the image's v axis.")
      .number("vertical_tilt_u_deg", "deg", kUnset, {-20, 20},
              "Direction of the vertical seen from the mirror's axis, towards the image's u axis. Not set: "
              "vertical_tilt_u_deg of camera.json; neither: 0.")
      .number("vertical_tilt_v_deg", "deg", kUnset, {-20, 20}, "The same towards the image's v axis.")
      .integer("self_calibration_frames", "", 20, {0, 1000},
               "Frames whose edges tell principal point and tilts, when they are straighter then. 0: none.")
      .number("rim_radius_min", "", 0.25, kRadius, "Smallest radius of the rim, share of the image's shorter side.")
      .number("rim_radius_max", "", 0.75, kRadius, "Largest radius of the rim, share of the image's shorter side.")
      .number("rim_aspect_min", "", 0.8, kAspect, "Smallest width over height of the rim (fx/fy of the camera).")
      .number("rim_aspect_max", "", 1.25, kAspect, "Largest width over height of the rim.")
      .number("rim_visible_share", "", 0.4, kShare,
              "Share of the rim's circumference that must be found; with less there is no measurement.")
      .number("rim_contrast", "", 5, {0.5, 255}, "Grey levels across the rim that count as seeing it.")
      .integer("azimuths", "", 1440, {180, 20000}, "Columns of the unrolled ring.")
      .integer("radii", "", 96, {8, 4000}, "Rows of the unrolled ring.")
      .number("ring_inner", "", 0.15, {0.02, 0.98}, "Where the ring begins, share of the rim's radius.")
      .number("ring_outer", "", 0.97, {0.05, 1}, "Where the ring ends.")
      .number("edge_smoothing_deg", "deg", 0.4, {0.05, 5}, "Standard deviation of the smoothing along azimuth.")
      .number("edge_length", "", 0.18, kShare, "Shortest edge, share of the ring's width.")
      .number("edge_significance", "", 8, {1, 1000},
              "Least evidence for an edge, in standard deviations of the image's noise.")
      .number("edge_contrast", "", 0.015, {0, 1}, "Least mean step, share of the ring's median brightness.")
      .number(
          "edge_width_deg", "deg", 0.61, {0.05, 10},
          "Largest standard deviation of an edge in the room; soft shadows are wider. Smoothing and blur come on top.")
      .number("edge_blur_px", "px", 1.05, {0, 20},
              "Least standard deviation of what camera and sampling add to an edge's width; more where the image's "
              "sharpest edges show more.")
      .number("edge_prominence", "", 0.45, {0, 1}, "How far the step must fall on both sides, share of its peak.")
      .number("std_floor_deg", "deg", 0, {0, 10},
              "Standard deviation of an azimuth beyond what the image itself shows.");
}
}  // namespace mrpt_ext
