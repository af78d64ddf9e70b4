#include "mrpt_ext/app/version.h"

namespace mrpt_ext
{
std::string_view version() { return MRPT_EXT_VERSION; }
std::string_view builtWith() { return MRPT_EXT_BUILT_WITH; }
}  // namespace mrpt_ext
