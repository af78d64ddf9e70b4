#pragma once

#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// The scenario with the errors that its random seed draws from its spread, each uniformly between none and the
/// largest. A scenario without spread is returned as it is.
[[nodiscard]] Scenario withRandomErrors(Scenario scenario);
}  // namespace mrpt_ext
