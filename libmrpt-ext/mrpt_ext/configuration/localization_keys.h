#pragma once

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
/// Every key of landmark-localization's .ini files: the one table behind validation, --list-keys and --explain.
[[nodiscard]] KeyTable localizationKeys();
}  // namespace mrpt_ext
