#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mrpt_ext
{
/// The clock of a log in action/sensory-frame form, whose steps are its sensory frames.
struct StepClock
{
  std::optional<double> step;  ///< [s] per sensory frame; absent: the stamps of the log hold
  std::string reason;          ///< one line for the user; empty when the stamps hold
};

/// Reads the whole log, whose steps shall count `step` seconds each where its stamps cannot be a clock: most of them
/// missing or equal, some going back, or so dense that the robot would be faster than any robot. Simulated logs are of
/// this kind, stamped while they were written.
/// Throws InputError (data) for a damaged log, and for a robot that leaves the plane.
[[nodiscard]] StepClock stepClockOf(const std::filesystem::path& path, double step);
}  // namespace mrpt_ext
