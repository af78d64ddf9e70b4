#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mrpt_ext/frames/logged_ranges.h"
#include "mrpt_ext/frames/reorder_buffer.h"
#include "mrpt_ext/frames/sensor_config.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/odometry_path.h"
#include "mrpt_ext/geometry/record_stream.h"

namespace mrpt_ext
{
struct FrameOptions
{
  double window = 0.05;      ///< [s] detections this close in time form one frame
  bool independent = false;  ///< no motion between frames
  OdometryCorrection odometry;
  SensorConfigs sensors;
  std::set<std::string> object_categories;  ///< detections of these are not landmarks
};

/// Frames in the order of time, one per call; nothing at the end.
using FrameFeed = std::function<std::optional<Frame>()>;

/// What must be known of the whole log before its first frame can be given.
struct LogOverview
{
  OdometryPath odometry;
  std::optional<double> fix_span;  ///< [s] longest time between the two ranges of a running fix; absent without fixes
};

/// Turns plain records into frames while they are read: the configuration of the sensors is applied, readings within
/// the window are moved to the stamp of the last one by odometry, the motion between frames is summed up. Holds what
/// lies within the window and the differences of the sensors' delays, however long the log is.
class FrameSynchronizer
{
 public:
  /// Everything given must outlive the cutter.
  FrameSynchronizer(RecordStream records, const LandmarkTable& map, const FrameOptions& options,
                    const LogOverview& overview);

  /// The next frame; its readings are empty only where missed detections count.
  [[nodiscard]] std::optional<Frame> next();
  /// Sightings of objects since the last call: up to the frame given last, after the last frame all. Without motions.
  [[nodiscard]] std::vector<Frame> takeObjectFrames();

  [[nodiscard]] const UnusableDetections& unusable() const { return unusable_; }  ///< of what was read so far
  [[nodiscard]] std::size_t detections() const { return detections_; }            ///< of landmarks, used so far

 private:
  /// A frame that measurements within the window of its first one still join.
  struct OpenFrame
  {
    Frame frame;
    double first_time = 0;
  };
  void read();
  void configure(const Record& record);
  void take(Record record);
  void take(Reading reading);
  void closeOver(std::optional<OpenFrame>& open, std::deque<Frame>& closed) const;
  [[nodiscard]] Frame& join(std::optional<OpenFrame>& open, double time) const;
  void complete(Frame& frame);

  RecordStream records_;
  const LandmarkTable& map_;
  const FrameOptions& options_;
  const LogOverview& overview_;
  ReorderBuffer queue_;  // configured delays disturb the order of time
  LoggedRanges ranges_;
  double now_ = 0;  // [s] everything before has left the queue
  bool ended_ = false;
  std::optional<OpenFrame> open_, open_objects_;
  std::deque<Frame> closed_, closed_objects_;
  std::deque<CompassRecord> headings_;
  std::optional<double> stamp_;  // [s] of the frame given last
  UnusableDetections unusable_;
  std::size_t detections_ = 0;
};
}  // namespace mrpt_ext
