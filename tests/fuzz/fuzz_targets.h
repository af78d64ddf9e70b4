#pragma once

#include <map>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// Reads bytes as one kind of input. Returns when they are valid or refused with an InputError; anything else that is
/// thrown, a crash or a hang is a fault.
using FuzzTarget = void (*)(std::string_view bytes);

/// All targets by the name of their folder in corpus/.
[[nodiscard]] const std::map<std::string, FuzzTarget>& fuzzTargets();
}  // namespace mrpt_ext
