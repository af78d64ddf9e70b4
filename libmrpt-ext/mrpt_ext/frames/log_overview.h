#pragma once

#include <vector>

#include "mrpt_ext/frames/frame_synchronizer.h"

namespace mrpt_ext
{
/// Odometry, and what else the cutter of frames must know of the whole log.
[[nodiscard]] LogOverview overviewOf(const RecordStream& records, const OdometryCorrection& correction);

/// A log cut into frames, in memory: for logs that are short or not in a file.
struct FrameSequence
{
  std::vector<Frame> frames;         ///< ordered by time; readings are empty only where missed ones count
  std::vector<Frame> object_frames;  ///< sightings of objects, one per frame of the same time in `frames` or between
  OdometryPath odometry;
  UnusableDetections unusable;
  std::size_t detections = 0;  ///< of landmarks, used
};

/// All frames of a FrameSynchronizer at once. The records may be in any order.
[[nodiscard]] FrameSequence buildFrames(std::vector<Record> records, const LandmarkTable& map,
                                        const FrameOptions& options);
}  // namespace mrpt_ext
