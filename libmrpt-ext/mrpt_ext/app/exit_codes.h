#pragma once

namespace mrpt_ext
{
/// What the apps return to the shell.
enum ExitCode : int
{
  kExitDone = 0,    ///< finished (also with verdict `ambiguous`)
  kExitFailed = 1,  ///< unreadable or damaged data, disk full, interrupted: what was finished is valid on disk
  kExitUsage = 2,   ///< wrong usage or configuration
  kExitLost = 3     ///< finished, but lost, or worse than --fail-above allows
};
}  // namespace mrpt_ext
