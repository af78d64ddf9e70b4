#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mrpt_ext/frames/log_overview.h"
#include "mrpt_ext/frames/logged_ranges.h"
#include "mrpt_ext/frames/reorder_buffer.h"
#include "mrpt_ext/frames/sensor_config.h"
#include "mrpt_ext/geometry/frame.h"

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
using FrameStream = std::function<std::optional<Frame>()>;

/// Turns records into frames as they come: applies the configuration of the sensors, moves readings within the window
/// to the stamp of the last one by odometry, sums up the motion between frames. Memory depends on the window and on the
/// differences of the sensors' delays, not on the length of the log. Records are read from a stream by next(), or
/// pushed.
class FrameSynchronizer
{
 public:
  /// All arguments must outlive the synchronizer.
  FrameSynchronizer(RecordStream records, const LandmarkTable& map, const FrameOptions& options,
                    const LogOverview& overview);
  /// For records that are pushed: each may be up to `lateness` [s] older than the newest one before it.
  FrameSynchronizer(const LandmarkTable& map, const FrameOptions& options, const LogOverview& overview,
                    double lateness);

  /// The next frame of the stream; its readings are empty only where missed detections count.
  [[nodiscard]] std::optional<Frame> next();

  /// Takes a record; one that is older than `lateness` allows is counted as unusable. Of odometry the time alone
  /// matters, as the news that what was measured before has come: its poses are those of the overview.
  void push(const Record& record);
  /// No record will follow.
  void close();
  /// Stamp [s] of the next frame, once no record can change it any more.
  [[nodiscard]] std::optional<double> readyStamp() const;
  /// That frame; the odometry of the overview must reach its stamp.
  [[nodiscard]] Frame pop();
  /// The frames to come need no odometry before this time [s]: a scan of theirs may have begun before the stamp of the
  /// last frame.
  [[nodiscard]] double odometryNeededFrom() const;

  /// Detections of objects since the last call, up to the last frame returned; all after the end. Without motions.
  [[nodiscard]] std::vector<Frame> takeObjectFrames();

  [[nodiscard]] const UnusableDetections& unusable() const { return unusable_; }  ///< of what was read so far
  [[nodiscard]] std::size_t detections() const { return detections_; }            ///< of landmarks, used so far

 private:
  /// A frame that still takes measurements within the window of its first one.
  struct OpenFrame
  {
    Frame frame;
    double first_time = 0;
  };
  void configure(const Record& record);
  void enqueue(Record record, const std::string& sensor);
  void advance();
  void take(Record record);
  void take(Reading reading);
  void closeOver(std::optional<OpenFrame>& open, std::deque<Frame>& closed) const;
  [[nodiscard]] Frame& frameAt(std::optional<OpenFrame>& open, double time) const;
  void moveToStamp(Reading& reading, double time) const;
  void complete(Frame& frame);

  RecordStream records_;
  const LandmarkTable& map_;
  const FrameOptions& options_;
  const LogOverview& overview_;
  ReorderBuffer queue_;  // configured delays disturb the order of time
  LoggedRanges ranges_;
  double now_ = -std::numeric_limits<double>::infinity();  // [s] everything before has left the queue
  bool ended_ = false;
  std::optional<OpenFrame> open_, open_objects_;
  std::deque<Frame> closed_, closed_objects_;
  std::deque<CompassRecord> headings_;
  std::optional<double> stamp_;  // [s] of the frame given last
  UnusableDetections unusable_;
  std::size_t detections_ = 0;
};
}  // namespace mrpt_ext
