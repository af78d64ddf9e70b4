#pragma once

#include "mrpt_ext/hypotheses/propose_poses.h"
#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/localizers/range_only_start.h"
#include "mrpt_ext/relocalization/measurement_window.h"
#include "mrpt_ext/relocalization/trajectory_relocalizer.h"

namespace mrpt_ext
{
/// The batch particle filter with its three sources of hypotheses: closed forms over a window of the last seconds; all
/// readings since the start, if they are ranges alone; and the trajectory of the last minutes, if all detections are
/// anonymous.
class ParticleFilterLocalizer : public FilterLocalizer
{
 public:
  /// `seed_window` [s]: window of readings for initialization and recovery. `search`: of this map, to share its index
  /// between filters; absent: one of its own.
  ParticleFilterLocalizer(const ParticleFilterOptions& options, const LandmarkTable& map, double seed_window,
                          std::uint64_t seed, std::uint64_t stream = 0,
                          std::shared_ptr<const GlobalPoseSearch> search = nullptr);

  Estimate process(const Frame& whole) override;
  [[nodiscard]] const FilterStep& lastStep() const override { return step_; }
  [[nodiscard]] const ParticleSet& particles() const override { return filter_.particles(); }
  [[nodiscard]] std::vector<LandmarkHistory> landmarkHistories() const override;

 private:
  [[nodiscard]] Proposal proposeFromWindow(WorkBudget& budget) const;
  [[nodiscard]] Proposal propose(WorkBudget& budget);

  LandmarkTable map_;
  std::shared_ptr<const GlobalPoseSearch> search_;
  PoseRegion region_;
  BiasModel biases_;
  ParticleFilter filter_;
  MeasurementWindow window_;
  RangeOnlyStart range_only_start_;
  TrajectoryRelocalizer relocalizer_;
  FilterStep step_;
};
}  // namespace mrpt_ext
