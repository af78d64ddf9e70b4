#pragma once

#include <algorithm>
#include <vector>

#include "mrpt_ext/frames/frame_synchronizer.h"

namespace mrpt_ext::testing
{
/// All frames of a short log in memory.
struct FrameSequence
{
  std::vector<Frame> frames;         ///< ordered by time; readings are empty only where missed detections count
  std::vector<Frame> object_frames;  ///< detections of objects
  OdometryPath odometry;
  UnusableDetections unusable;
  std::size_t detections = 0;  ///< of landmarks, used
};

/// All frames of a FrameSynchronizer at once. The records may be in any order.
[[nodiscard]] inline FrameSequence buildFrames(std::vector<Record> records, const LandmarkTable& map,
                                               const FrameOptions& options)
{
  std::stable_sort(records.begin(), records.end(),
                   [](const Record& a, const Record& b) { return timeOf(a) < timeOf(b); });
  LogOverview overview = overviewOf(streamOf(records), options.odometry);
  FrameSequence sequence;
  FrameSynchronizer synchronizer(streamOf(records), map, options, overview);
  for (bool more = true; more;)
  {
    auto frame = synchronizer.next();
    more = frame.has_value();
    if (frame) sequence.frames.push_back(std::move(*frame));
    for (Frame& objects : synchronizer.takeObjectFrames()) sequence.object_frames.push_back(std::move(objects));
  }
  sequence.unusable = synchronizer.unusable();
  sequence.detections = synchronizer.detections();
  sequence.odometry = std::move(overview.odometry);
  return sequence;
}
}  // namespace mrpt_ext::testing
