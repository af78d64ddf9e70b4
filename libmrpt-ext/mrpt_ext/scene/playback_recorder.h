#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/localizers/filter_localizer.h"

namespace mrpt_ext
{
/// Records the playback of the report: detections, modes and particles of at most 1000 evenly spaced frames, with few
/// enough particles to keep a report small. Draws no random numbers, changes nothing.
class PlaybackRecorder
{
 public:
  /// `frames`: number of frames of the run; `map` must outlive the recorder.
  PlaybackRecorder(std::size_t frames, const LandmarkTable& map);

  /// After every frame; `filter` may be null.
  void add(const Frame& frame, const FilterLocalizer* filter, std::vector<PlaybackStep>& playback);

 private:
  const LandmarkTable& map_;
  std::size_t stride_, particles_per_step_;
  std::size_t next_ = 0;
};

/// Detections of a frame, and modes and at most `particles` particles of the filter (may be null).
[[nodiscard]] PlaybackStep playbackStep(const Frame& frame, const FilterLocalizer* filter, const LandmarkTable& map,
                                        std::size_t particles);

/// `count` particles of equal weight, drawn systematically (all of them when there are no more).
[[nodiscard]] std::vector<Pose2> particlesByWeight(const ParticleSet& particles, std::size_t count);
}  // namespace mrpt_ext
