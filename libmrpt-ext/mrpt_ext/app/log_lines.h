#pragma once

#include <iosfwd>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// `landmark-localization CONFIG --lines`: writes the records of the log within the window to `out`, as the lines that
/// --live reads. What it does not read is left out and counted on `err`. Returns the exit code.
int writeLogLines(const Settings& settings, const LogWindow& window, std::ostream& out, std::ostream& err);
}  // namespace mrpt_ext
