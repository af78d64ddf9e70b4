#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Where to read what to do about a verdict that is not `ok`.
inline constexpr const char* kAdviceSection = "section \"What to do\" of apps/landmark-localization/README.md";

/// Spells without `ok`.
struct SpellsNotOk
{
  std::vector<VerdictSpell> longest;  ///< at most as many as asked for, in order of time
  std::size_t others = 0;             ///< ... and how many are left out
};
[[nodiscard]] SpellsNotOk spellsNotOk(const RunScore& score, std::size_t most);

/// "ok 97 %, ambiguous 3 %, lost 0 % of the frames"; empty where the shares are not known.
[[nodiscard]] std::string sharesText(const VerdictShares& shares);
/// "312.4 to 325.1 s"
[[nodiscard]] std::string spanText(const VerdictSpell& spell);
/// True when the run is not `ok`, or was not for some time after it had been.
[[nodiscard]] bool needsAdvice(const RunScore& score);
/// Lines of the console below the verdict: shares, the longest spells without `ok`, hints, and where to read what
/// to do.
[[nodiscard]] std::string verdictHistoryText(const RunScore& score);
}  // namespace mrpt_ext
