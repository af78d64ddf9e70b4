#include "mrpt_ext/evaluation/verdict_history.h"

namespace mrpt_ext
{
void VerdictHistory::add(double time, Verdict verdict, const std::string& reason)
{
  ++frames_[static_cast<std::size_t>(verdict)];
  if (spells_.empty() || spells_.back().verdict != verdict)
    spells_.push_back({time, time, verdict, reason});
  else
    spells_.back().to = time;
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
