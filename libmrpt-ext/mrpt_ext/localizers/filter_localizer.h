#pragma once

#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/localizers/localizer.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext
{
/// What every engine of the particle filter lets the report see.
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

/// A filter step as an estimate: the best mode, never the mean across modes; the others are its candidates.
[[nodiscard]] Estimate estimateFrom(const FilterStep& step, double time);

/// Heading of the best mode, while the filter's verdict is ok.
[[nodiscard]] std::optional<HeadingPrior> sureHeading(const FilterLocalizer& filter);
}  // namespace mrpt_ext
