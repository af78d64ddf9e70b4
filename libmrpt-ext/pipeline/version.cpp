#include "mrpt_ext/pipeline/version.h"

namespace mrpt_ext
{
std::string_view version() { return MRPT_EXT_VERSION; }
}  // namespace mrpt_ext
