#pragma once

#include "mrpt_ext/hypotheses/propose_poses.h"
#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/localizers/frame_joiner.h"

namespace mrpt_ext
{
/// The batch particle filter, seeded by the closed forms over the readings of the last seconds.
class ParticleFilterLocalizer : public FilterLocalizer
{
 public:
  /// `seed_window` [s]: how far back readings are joined by odometry when hypotheses are needed.
  ParticleFilterLocalizer(const ParticleFilterOptions& options, const LandmarkTable& map, double seed_window,
                          std::uint64_t seed, std::uint64_t stream = 0);

  Estimate process(const Frame& frame) override;
  [[nodiscard]] const FilterStep& lastStep() const override { return step_; }
  [[nodiscard]] const ParticleSet& particles() const override { return filter_.particles(); }
  [[nodiscard]] std::vector<LandmarkHistory> landmarkHistories() const override;

 private:
  LandmarkTable map_;
  PoseRegion region_;
  ParticleFilter filter_;
  FrameJoiner joiner_;
  FilterStep step_;
};
}  // namespace mrpt_ext
