#pragma once

#include <vector>

#include "mrpt_ext/settings/settings.h"
#include "sample.h"

namespace mrpt_ext::papers
{
/// Running fixes with one way and one error of dead reckoning: position errors [m].
struct FixStudyRow
{
  double ratio = 0;                   ///< way / standard deviation of a range
  double displacement_error = 0;      ///< standard deviation of the way, each axis / way
  double missed = 0;                  ///< share of the fixes whose circles do not meet
  Sample fix, fix_bound;              ///< two ranges and a heading; a missed one counts with the middle of the gap
  Sample likeliest, likeliest_bound;  ///< with the bearing
};

/// What paper 004 leaves open, one row per way and error of dead reckoning.
[[nodiscard]] std::vector<FixStudyRow> runFixStudy(const Settings& settings);
}  // namespace mrpt_ext::papers
