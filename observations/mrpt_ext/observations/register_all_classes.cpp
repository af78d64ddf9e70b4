#include "mrpt_ext/observations/register_all_classes.h"

#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationRunningFix.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"

namespace mrpt_ext
{
void registerAllObservationClasses()
{
  mrpt::rtti::registerClass(CLASS_ID(CObservationLandmarkBearings));
  mrpt::rtti::registerClass(CLASS_ID(CObservationStereoRanges));
  mrpt::rtti::registerClass(CLASS_ID(CObservationRunningFix));
}

namespace
{
// When the library is loaded. No MRPT_INITIALIZER: it may run before the class ids, in files above this one, have their
// values.
[[maybe_unused]] const bool kAreRegistered = (registerAllObservationClasses(), true);
}  // namespace
}  // namespace mrpt_ext
