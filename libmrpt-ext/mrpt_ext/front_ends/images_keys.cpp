#include "mrpt_ext/front_ends/images_keys.h"

namespace mrpt_ext
{
KeyTable imagesKeys()
{
  KeyTable table({{"Images",
                   "sensor",
                   KeyType::choice,
                   "",
                   "",
                   {},
                   {{"conic_mirror", {}}, {"movis", {}}, {"stereo_goal", {}}},
                   "What took the images: conic_mirror, one camera below a cone, giving azimuths of vertical edges; "
                   "movis, three cameras below hyperbolic mirrors, giving azimuths of corner poles and ball; "
                   "stereo_goal, a narrow stereo pair on a football field, giving goal corners and line landmarks."}});
  return table.append(conicMirrorKeys()).append(movisKeys()).append(stereoGoalKeys());
}
}  // namespace mrpt_ext
