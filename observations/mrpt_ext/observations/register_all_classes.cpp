#include "mrpt_ext/observations/register_all_classes.h"

#include <mrpt/core/initializer.h>

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
}  // namespace mrpt_ext

MRPT_INITIALIZER(registerMrptExtObservations) { mrpt_ext::registerAllObservationClasses(); }
