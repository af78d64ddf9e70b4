#include "mrpt_ext/report/verdict_text.h"

#include <algorithm>

#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
SpellsNotOk spellsNotOk(const RunScore& score, std::size_t most)
{
  SpellsNotOk result;
  if (!score.verdict_spells) return result;
  std::vector<VerdictSpell>& spells = result.longest;
  std::copy_if(score.verdict_spells->begin(), score.verdict_spells->end(), std::back_inserter(spells),
               [](const VerdictSpell& spell) { return spell.verdict != Verdict::ok; });
  if (spells.size() <= most) return result;
  std::stable_sort(spells.begin(), spells.end(),
                   [](const VerdictSpell& a, const VerdictSpell& b) { return a.to - a.from > b.to - b.from; });
  result.others = spells.size() - most;
  spells.resize(most);
  std::sort(spells.begin(), spells.end(), [](const VerdictSpell& a, const VerdictSpell& b) { return a.from < b.from; });
  return result;
}

std::string sharesText(const VerdictShares& shares)
{
  if (!shares.ok) return {};
  return "ok " + percentText(shares.ok) + ", ambiguous " + percentText(shares.ambiguous) + ", lost " +
         percentText(shares.lost) + " of the frames";
}

std::string spanText(const VerdictSpell& spell)
{
  return numberText(spell.from, 1) + " to " + numberText(spell.to, 1) + " s";
}

bool needsAdvice(const RunScore& score)
{
  if (score.verdict != Verdict::ok) return true;
  if (!score.verdict_spells) return false;
  bool was_ok = false;
  for (const VerdictSpell& spell : *score.verdict_spells)
  {
    if (was_ok && spell.verdict != Verdict::ok) return true;
    was_ok = was_ok || spell.verdict == Verdict::ok;
  }
  return false;
}

std::string verdictHistoryText(const RunScore& score)
{
  constexpr std::size_t kShown = 3;
  const std::string indent(9, ' ');
  std::string text;
  if (const std::string shares = sharesText(score.verdict_shares); !shares.empty()) text += indent + shares + '\n';
  const SpellsNotOk spells = spellsNotOk(score, kShown);
  for (const VerdictSpell& spell : spells.longest)
    text += indent + spanText(spell) + " " + toString(spell.verdict) +
            (spell.reason.empty() ? "" : ": " + spell.reason) + '\n';
  if (spells.others > 0)
    text += indent + "and " + countedText(static_cast<double>(spells.others), "shorter spell") +
            " without `ok`, see report.html\n";
  for (const std::string& hint : score.hints) text += "hint     " + hint + '\n';
  if (needsAdvice(score)) text += std::string("what to do: ") + kAdviceSection + '\n';
  return text;
}
}  // namespace mrpt_ext
