#pragma once

#include <filesystem>

#include "mrpt_ext/rawlog/rawlog_translator.h"

namespace mrpt_ext
{
/// Reads the whole log, whose steps shall count `step` seconds each where its stamps cannot be a clock: most of them
/// missing or equal, some going back, or so dense that the robot would be faster than any robot. Simulated logs are of
/// this kind, stamped while they were written.
/// Throws InputError (data) for a damaged log, and for a robot that leaves the plane.
[[nodiscard]] StepClock stepClockOf(const std::filesystem::path& path, double step);
}  // namespace mrpt_ext
