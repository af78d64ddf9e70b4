#pragma once

namespace mrpt_ext
{
/// An estimate shrunk towards zero by what chance may have put into it: nothing is left of one within `by_chance`
/// standard deviations (`variance` of the estimate), nearly all of a large one (positive-part estimator of James and
/// Stein, 1961).
[[nodiscard]] inline double significantPart(double estimate, double variance, double by_chance)
{
  const double chance = by_chance * by_chance * variance;
  if (!(estimate * estimate > chance)) return 0;
  return estimate - chance / estimate;
}
}  // namespace mrpt_ext
