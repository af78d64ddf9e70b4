#pragma once

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
/// Keys of the particle filter beyond those that MRPT has a name for.
[[nodiscard]] KeyTable filterKeys();

/// The keys of MRPT's own sections, with MRPT's meaning: [PF_options], [KLD_options], [MetricMap].
[[nodiscard]] KeyTable mrptKeys();
}  // namespace mrpt_ext
