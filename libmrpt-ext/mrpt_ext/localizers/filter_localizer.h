#pragma once

#include <span>

#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/localizers/localizer.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext
{
/// A particle filter of either engine, with what the report shows of it.
class FilterLocalizer : public Localizer
{
 public:
  [[nodiscard]] std::string name() const override { return "particle_filter"; }
  [[nodiscard]] bool continuous() const override { return true; }
  [[nodiscard]] virtual const FilterStep& lastStep() const = 0;
  [[nodiscard]] virtual const ParticleSet& particles() const = 0;
  /// One entry per landmark of the map.
  [[nodiscard]] virtual std::vector<LandmarkHistory> landmarkHistories() const = 0;
};

/// The best mode of a filter as estimate, never the mean of several; all modes as candidates.
[[nodiscard]] Estimate estimateFrom(std::span<const Mode> heaviest_first, Verdict verdict, bool heading_known,
                                    const std::string& source, double time);
[[nodiscard]] Estimate estimateFrom(const FilterStep& step, double time);

/// Heading of the best mode if the verdict is `ok`.
[[nodiscard]] std::optional<HeadingPrior> confidentHeading(const FilterLocalizer& filter);
}  // namespace mrpt_ext
