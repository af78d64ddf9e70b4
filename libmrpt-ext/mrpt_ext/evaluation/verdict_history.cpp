#include "mrpt_ext/evaluation/verdict_history.h"

#include <algorithm>
#include <bit>
#include <cctype>

namespace mrpt_ext
{
namespace
{
/// The reason without its numbers, which change from frame to frame.
std::string kindOf(std::string reason)
{
  std::erase_if(reason, [](unsigned char c) { return std::isdigit(c) || c == '.' || c == '-'; });
  return reason;
}
}  // namespace

void VerdictHistory::add(double time, Verdict verdict, const std::string& reason)
{
  ++frames_[static_cast<std::size_t>(verdict)];
  if (!spells_.empty())
  {
    causes_[current_].held += time - spells_.back().to;
    explainSpell();
  }
  if (spells_.empty() || spells_.back().verdict != verdict)
  {
    spells_.push_back({time, time, verdict, {}});
    causes_.clear();
  }
  takeReason(reason);
  spells_.back().to = time;
  explainSpell();
}

void VerdictHistory::explainSpell()
{
  spells_.back().reason = std::ranges::max_element(causes_, {}, &Cause::held)->wording;
}

void VerdictHistory::takeReason(const std::string& reason)
{
  const std::string kind = kindOf(reason);
  auto cause = std::ranges::find(causes_, kind, &Cause::kind);
  if (cause == causes_.end()) cause = causes_.insert(cause, {.kind = kind});
  // Taken anew whenever the count has doubled, so the numbers are neither those of the spell's start nor of its end.
  if (std::has_single_bit(++cause->frames)) cause->wording = reason;
  current_ = static_cast<std::size_t>(cause - causes_.begin());
}

VerdictShares VerdictHistory::shares() const
{
  const std::size_t all = frames_[0] + frames_[1] + frames_[2];
  if (all == 0) return {};
  const auto share = [&](Verdict verdict)
  { return static_cast<double>(frames_[static_cast<std::size_t>(verdict)]) / static_cast<double>(all); };
  return {share(Verdict::ok), share(Verdict::ambiguous), share(Verdict::lost)};
}
}  // namespace mrpt_ext
