#pragma once

#include <algorithm>
#include <cstdlib>

namespace mrpt_ext::testing
{
/// Under the sanitizers, which take several times as long (tests/sanitizers.sh sets LANDMARK_SHORT_TESTS): the same
/// code runs on less, and bounds that hold for many runs only are left to the ordinary tests.
[[nodiscard]] inline bool isShort() { return std::getenv("LANDMARK_SHORT_TESTS") != nullptr; }

/// Runs, trials, images or cuts of a test: all of them, or a tenth.
[[nodiscard]] inline int runsOfTest(int all) { return isShort() ? std::max(1, all / 10) : all; }
}  // namespace mrpt_ext::testing
