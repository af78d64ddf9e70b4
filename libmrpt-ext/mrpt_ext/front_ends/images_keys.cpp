#include "mrpt_ext/front_ends/images_keys.h"

#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
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
