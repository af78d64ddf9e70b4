#include "mrpt_ext/maps/register_all_classes.h"

#include "mrpt_ext/maps/CLandmarkMap2D.h"
#include "mrpt_ext/observations/register_all_classes.h"

namespace mrpt_ext
{
void registerAllClasses()
{
  registerAllObservationClasses();
  mrpt::rtti::registerClass(CLASS_ID(CLandmarkMap2D));  // its .ini name is registered when the library is loaded
}

namespace
{
// When the library is loaded. No MRPT_INITIALIZER: it may run before the class ids, in files above this one, have their
// values.
[[maybe_unused]] const bool kAreRegistered = (registerAllClasses(), true);
}  // namespace
}  // namespace mrpt_ext
