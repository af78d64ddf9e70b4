#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/localizers/filter_localizer.h"

namespace mrpt_ext
{
/// Keeps what the map of the report plays back: of at most 1000 frames, evenly spread, what was seen and what the
/// filter believed, with so few particles that a report stays small. Draws no random numbers, changes nothing.
class PlaybackRecorder
{
 public:
  /// `frames` that will come; `map` must outlive the recorder.
  PlaybackRecorder(std::size_t frames, const LandmarkTable& map);

  /// After every frame; `filter` may be null.
  void add(const Frame& frame, const FilterLocalizer* filter, std::vector<PlaybackStep>& playback);

 private:
  const LandmarkTable& map_;
  std::size_t stride_, particles_per_step_;
  std::size_t next_ = 0;
};

/// What can be shown of one frame: the detections, and of the filter (may be null) the modes and at most `particles`.
[[nodiscard]] PlaybackStep playbackStep(const Frame& frame, const FilterLocalizer* filter, const LandmarkTable& map,
                                        std::size_t particles);

/// `count` particles that each stand for the same share of the weight (all of them when there are no more).
[[nodiscard]] std::vector<Pose2> particlesByWeight(const ParticleSet& particles, std::size_t count);
}  // namespace mrpt_ext
