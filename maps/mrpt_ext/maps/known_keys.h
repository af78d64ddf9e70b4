#pragma once

#include <string>
#include <vector>

namespace mrpt::config
{
class CConfigFileBase;
}  // namespace mrpt::config

namespace mrpt_ext
{
/// Throws InputError (configuration) when the section holds a key that is not `known`; MRPT itself would ignore it.
void rejectUnknownKeys(const mrpt::config::CConfigFileBase& source, const std::string& section,
                       const std::vector<std::string>& known);
}  // namespace mrpt_ext
