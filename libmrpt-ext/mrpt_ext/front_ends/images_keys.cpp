#include "mrpt_ext/front_ends/images_keys.h"

namespace mrpt_ext
{
KeySection pinholeKeys(const std::string& section)
{
  constexpr ValueRange kPixels{1, 1e5};
  return KeySection(section)
      .integer("image_width", "px", kUnset, {64, 20000}, "Not set: width of camera.json.")
      .integer("image_height", "px", kUnset, {64, 20000}, "Not set: height of camera.json.")
      .number("focal_u_px", "px", kUnset, kPixels, "Not set: fx of camera.json.")
      .number("focal_v_px", "px", kUnset, kPixels, "Not set: fy of camera.json.")
      .number("centre_u_px", "px", kUnset, {-1e5, 1e5}, "Not set: cx of camera.json.")
      .number("centre_v_px", "px", kUnset, {-1e5, 1e5}, "Not set: cy of camera.json.");
}

KeyTable imagesKeys()
{
  KeyTable table =
      KeySection("Images")
          .choice("sensor", "",
                  {{"conic_mirror", {}, "one camera below a cone: azimuths of vertical edges"},
                   {"movis", {}, "three cameras below hyperbolic mirrors: azimuths of corner poles and ball"},
                   {"stereo_goal", {}, "a narrow stereo pair on a football field: goal corners and line landmarks"},
                   {"tags", {}, "one camera and fiducial tags (AprilTag, ArUco): their bearings and ranges"}},
                  "What took the images.")
          .forBeginners();
  return table.append(conicMirrorKeys()).append(movisKeys()).append(stereoGoalKeys()).append(tagsKeys());
}
}  // namespace mrpt_ext
