#pragma once

#include "sample.h"
#include "stereo_rig.h"

namespace mrpt_ext::papers
{
/// Absolute errors of ranges to goal corners: lengths [m] and shares of the true range.
struct RangeErrors
{
  Sample absolute, relative;
};

struct RangeResult
{
  double width = 0;        ///< [px]
  RangeErrors paper;       ///< whole pixels, ranges too long
  RangeErrors calibrated;  ///< whole pixels, the scale taken off as a calibration would
  RangeErrors best;        ///< between pixels, the scale taken off
  RangeErrors bound;       ///< at the Cramer-Rao bound of `best`, drawn
};

/// Tables 3 and 4 of paper 004, one result per image width.
[[nodiscard]] std::vector<RangeResult> runRangeExperiment(const Settings& settings);

/// The same for all places of [Ranges] other_margins_m and other_min_ranges_m.
[[nodiscard]] std::vector<std::vector<RangeResult>> tryOtherPlaces(Settings settings);
}  // namespace mrpt_ext::papers
