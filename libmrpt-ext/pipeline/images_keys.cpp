#include "mrpt_ext/pipeline/images_keys.h"

#include "mrpt_ext/pipeline/conic_mirror_front_end.h"

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
                   {{"conic_mirror", {}}},
                   "What took the images: conic_mirror, one camera below a cone, giving azimuths of vertical edges."}});
  return table.append(conicMirrorKeys());
}
}  // namespace mrpt_ext
