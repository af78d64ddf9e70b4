#include "mrpt_ext/filter/integrity/recovery_policy.h"

#include <algorithm>

namespace mrpt_ext
{
Recovery RecoveryPolicy::decide(const PosteriorState& state, double elapsed)
{
  since_injection_ += elapsed;
  Recovery recovery;
  if (state.suspicious && since_injection_ >= reseed_interval_)
  {
    recovery = {Recovery::Kind::reseed, options_.relocalization_prior};
    reseed_interval_ = std::min(2 * reseed_interval_, std::max(max_reseed_interval_, options_.min_interval));
  }
  else if (isVerificationDue(state))
  {
    recovery = {Recovery::Kind::verify,
                options_.relocalization_prior * (kMinVerificationInterval / verification_interval_)};
    verification_interval_ = std::min(2 * verification_interval_, kMaxVerificationInterval);
  }
  if (recovery.due()) since_injection_ = 0;
  return recovery;
}

bool RecoveryPolicy::isVerificationDue(const PosteriorState& state) const
{
  if (state.ends_gap) return false;
  if (state.unimodal && state.verified)
    return since_injection_ >= kMaxVerificationInterval && (state.has_trajectory || state.anonymous);
  return since_injection_ >= verification_interval_ && (state.unimodal || state.has_trajectory);
}
}  // namespace mrpt_ext
