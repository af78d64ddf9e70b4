#include "mrpt_ext/filter/integrity/slip_test.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
void SlipTest::suspect(double seconds)
{
  const double prior = kSlipRate * seconds;
  if (prior > 0) log_odds_ = std::clamp(-std::log(prior), 0.0, log_odds_);
  features_.clear();
}

void SlipTest::move(const OdometryMotion& motion)
{
  if (!refuted()) features_.move(motion);
}

void SlipTest::count(const Reading& part, double log_density)
{
  if (refuted()) return;
  log_odds_ = std::max(0.0, log_odds_ + log_density - features_.observe(part).log_density);
}

void SlipTest::skip(const Reading& part)
{
  if (!refuted()) (void)features_.observe(part);
}

void SlipTest::track(const Reading& correlated)
{
  if (!refuted()) features_.track(correlated);
}
}  // namespace mrpt_ext
