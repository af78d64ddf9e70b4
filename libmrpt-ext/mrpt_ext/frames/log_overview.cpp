#include "mrpt_ext/frames/frame_sequence.h"

#include <algorithm>

namespace mrpt_ext
{
LogOverview overviewOf(const RecordStream& records, const OdometryCorrection& correction)
{
  LogOverview overview{.odometry = OdometryPath(correction), .fix_span = {}};
  while (const auto record = records())
  {
    if (const auto* pose = std::get_if<OdometryRecord>(&*record)) overview.odometry.add(*pose);
    if (const auto* fix = std::get_if<RunningFixReading>(&*record))
      overview.fix_span = std::max(overview.fix_span.value_or(0), fix->time - fix->first_time);
  }
  overview.odometry = OdometryPath(overview.odometry);  // a copy has no room to grow, which is not needed any more
  return overview;
}

FrameSequence buildFrames(std::vector<Record> records, const LandmarkTable& map, const FrameOptions& options)
{
  std::stable_sort(records.begin(), records.end(),
                   [](const Record& a, const Record& b) { return timeOf(a) < timeOf(b); });
  LogOverview overview = overviewOf(streamOf(records), options.odometry);
  FrameSequence sequence;
  FrameSynchronizer cutter(streamOf(records), map, options, overview);
  for (bool more = true; more;)
  {
    auto frame = cutter.next();
    more = frame.has_value();
    if (frame) sequence.frames.push_back(std::move(*frame));
    for (Frame& objects : cutter.takeObjectFrames()) sequence.object_frames.push_back(std::move(objects));
  }
  sequence.unusable = cutter.unusable();
  sequence.detections = cutter.detections();
  sequence.odometry = std::move(overview.odometry);
  return sequence;
}
}  // namespace mrpt_ext
