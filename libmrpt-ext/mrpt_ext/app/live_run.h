#pragma once

#include <iosfwd>

#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// `landmark-localization CONFIG --live`: reads JSON lines from `in` until it ends, writes each estimate to `out` as
/// soon as it is final, and a summary with the latencies at the end. A mistake in a line is a line of its own; the next
/// lines are read. Returns the exit code: 3 when the last verdict is `lost`, 1 when lines were wrong.
int runLive(const Settings& settings, std::istream& in, std::ostream& out);
}  // namespace mrpt_ext
