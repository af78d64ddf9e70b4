#include "mrpt_ext/maps/register_all_classes.h"

#include <mrpt/core/initializer.h>

#include "mrpt_ext/maps/CLandmarkMap2D.h"
#include "mrpt_ext/observations/register_all_classes.h"

namespace mrpt_ext
{
void registerAllClasses()
{
  registerAllObservationClasses();
  mrpt::rtti::registerClass(CLASS_ID(CLandmarkMap2D));  // its .ini name is registered when the library is loaded
}
}  // namespace mrpt_ext

MRPT_INITIALIZER(registerMrptExtMaps) { mrpt_ext::registerAllClasses(); }
