#pragma once

#include "mrpt_ext/hypotheses/propose_poses.h"
#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/localizers/range_only_start.h"
#include "mrpt_ext/relocalization/measurement_window.h"
#include "mrpt_ext/relocalization/trajectory_relocalizer.h"

namespace mrpt_ext
{
/// The batch particle filter, seeded by the closed forms over the readings of the last seconds, and by what was seen
/// without names along the way (localizeOverTrajectory).
class ParticleFilterLocalizer : public FilterLocalizer
{
 public:
  /// `seed_window` [s]: how far back readings are joined by odometry when hypotheses are needed. `search`: of this map,
  /// to share its index between filters; absent: one of its own.
  ParticleFilterLocalizer(const ParticleFilterOptions& options, const LandmarkTable& map, double seed_window,
                          std::uint64_t seed, std::uint64_t stream = 0,
                          std::shared_ptr<const GlobalPoseSearch> search = nullptr);

  Estimate process(const Frame& frame) override;
  [[nodiscard]] const FilterStep& lastStep() const override { return step_; }
  [[nodiscard]] const ParticleSet& particles() const override { return filter_.particles(); }
  [[nodiscard]] std::vector<LandmarkHistory> landmarkHistories() const override;

 private:
  LandmarkTable map_;
  std::shared_ptr<const GlobalPoseSearch> search_;
  PoseRegion region_;
  BiasModel biases_;
  ParticleFilter filter_;
  MeasurementWindow joiner_;
  RangeOnlyStart history_;
  TrajectoryRelocalizer way_;
  FilterStep step_;
};
}  // namespace mrpt_ext
