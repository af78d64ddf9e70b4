#include "mrpt_ext/correspondence/false_alarms_bearings.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/correspondence/binomial.h"
#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGateShare = 1.9;  // of what a gate per bearing lets through, and of the triples' unequal strengths
}

double expectedFalsePoses(const BearingFalseAlarmModel& chance, int matched)
{
  const int m = std::max(matched, 3), n = chance.bearings;
  if (n < m) return 0;
  const double freedom = m > 3 ? kGateShare * std::exp(0.5 * logChoose(m, 3)) : 1;
  return chance.poses_per_triple * freedom * std::exp(logChoose(n, 3) - logChoose(m, 3)) *
         binomialTail(n - 3, m - 3, chance.chance);
}

double chanceMatchProbability(double gate, double in_view)
{
  return 1 - std::pow(1 - std::min(gate / kPi, 1.0), std::max(in_view, 0.0));
}
}  // namespace mrpt_ext
