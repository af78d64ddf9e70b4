#include "mrpt_ext/filter/integrity/slip_test.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
void SlipTest::suspect(double seconds)
{
  log_odds_ = std::min(log_odds_, -std::log(std::clamp(kSlipRate * seconds, std::exp(-kMaxLogOdds), 1.0)));
  features_.clear();
}

void SlipTest::move(const OdometryMotion& motion)
{
  if (isSuspected()) features_.move(motion);
}

void SlipTest::count(const Reading& part, double log_density, double max_range)
{
  if (!isSuspected()) return;
  log_odds_ = std::min(log_odds_ + log_density - features_.observe(part, max_range).log_density, kMaxLogOdds);
}

void SlipTest::skip(const Reading& part, double max_range)
{
  if (isSuspected()) (void)features_.observe(part, max_range);
}

void SlipTest::track(const Reading& correlated)
{
  if (isSuspected()) features_.track(correlated);
}
}  // namespace mrpt_ext
