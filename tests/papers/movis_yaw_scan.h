#pragma once

#include <array>
#include <vector>

#include "mrpt_ext/settings/settings.h"
#include "sample.h"

namespace mrpt_ext::papers
{
/// What paper 001 prints of D, before and after eq 8 (means and medians in m; rms: after / before).
struct PrintedLattice
{
  static constexpr double kMeanBefore = 0.466, kMeanAfter = 0.356, kMedianBefore = 0.43, kMedianAfter = 0.23;
  static constexpr double kRmsRatio = 0.906;
  static constexpr double kHeadingDeg = 7.4;        ///< mean |beta| that its tables imply
  static constexpr const char* kWorseAt = "C H M";  ///< points that eq 8 makes worse
};

/// The closed form with cameras that are turned so and so, over some visits of the lattice.
struct YawTry
{
  double std_bearing = 0;       ///< [rad]
  std::array<double, 2> yaw{};  ///< [rad] M1, M2
  Sample mean_before, mean_after, median_before, median_after, rms_ratio, slope_after;
  double agreement = 0;   ///< share of points and visits in which eq 8 helps or harms as printed
  double misfit = 0;      ///< root of the summed squared relative differences of the six figures above
  bool explains = false;  ///< all five printed figures lie in what 90 % of the visits give

  [[nodiscard]] bool explainsHeading() const;  ///< the same for the heading
};

/// All of [YawScan]: those that explain the print first, then by misfit.
[[nodiscard]] std::vector<YawTry> scanYaw(const Settings& settings);

/// The first of them with cameras turned by at most half a degree, as may happen on a mount; null when there is none.
[[nodiscard]] const YawTry* likeliestMount(const std::vector<YawTry>& tries);
}  // namespace mrpt_ext::papers
