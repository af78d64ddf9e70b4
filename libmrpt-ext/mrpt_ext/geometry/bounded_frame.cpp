#include "mrpt_ext/geometry/bounded_frame.h"

#include <algorithm>

#include "mrpt_ext/geometry/even_choice.h"

namespace mrpt_ext
{
namespace
{
/// Keeps a share of a list that goes on over several readings: all together `wanted` of `all`.
class FairShare
{
 public:
  FairShare(std::size_t wanted, std::size_t all) : wanted_(wanted), all_(all) {}
  /// Of the next `count` entries.
  std::size_t next(std::size_t count)
  {
    const std::size_t before = wanted_ * position_ / all_;
    position_ += count;
    return wanted_ * position_ / all_ - before;
  }

 private:
  std::size_t wanted_, all_, position_ = 0;
};
}  // namespace

std::size_t detectionCount(const Frame& frame)
{
  std::size_t count = frame.fixes.size();
  for (const Reading& reading : frame.readings) count += reading.detections.size();
  return count;
}

std::optional<Frame> boundedFrame(const Frame& frame, std::size_t most)
{
  const std::size_t count = detectionCount(frame);
  if (count <= most) return std::nullopt;
  FairShare share(most, count);
  Frame bounded{frame.time, frame.motion, {}, {}, frame.compass};
  for (const Reading& reading : frame.readings)
  {
    Reading some = reading;
    some.detections.clear();
    const std::span<const Detection> detections = reading.detections;
    for (const std::size_t d : evenChoice(detections, share.next(detections.size())))
      some.detections.push_back(detections[d]);
    if (some.detections.size() < detections.size()) some.model.detection_probability.reset();
    if (!some.detections.empty() || detections.empty()) bounded.readings.push_back(std::move(some));
  }
  for (const RunningFixReading& fix : frame.fixes)
    if (share.next(1) > 0) bounded.fixes.push_back(fix);
  return bounded;
}

std::optional<Frame> affordableFrame(const Frame& frame, double operations, double most_operations)
{
  if (operations <= most_operations) return std::nullopt;
  const double kept = static_cast<double>(detectionCount(frame)) * most_operations / operations;
  return boundedFrame(frame, std::max<std::size_t>(1, static_cast<std::size_t>(kept)));
}
}  // namespace mrpt_ext
