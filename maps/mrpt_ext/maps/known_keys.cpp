#include "mrpt_ext/maps/known_keys.h"

#include <mrpt/config/CConfigFileBase.h>

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
void rejectUnknownKeys(const mrpt::config::CConfigFileBase& source, const std::string& section,
                       const std::vector<std::string>& known)
{
  std::vector<std::string> keys;
  source.getAllKeys(section, keys);
  for (const std::string& key : keys)
  {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string expected;
    for (const std::string& name : known) expected += (expected.empty() ? "" : ", ") + name;
    throw configurationError("[" + section + "] " + key + ": unknown key, expected one of " + expected);
  }
}
}  // namespace mrpt_ext
