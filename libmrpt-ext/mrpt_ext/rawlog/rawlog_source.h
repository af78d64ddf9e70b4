#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/frames/reorder_buffer.h"
#include "mrpt_ext/geometry/observation_count.h"
#include "mrpt_ext/observations/usable_detections.h"

namespace mrpt::serialization
{
class CSerializable;
}  // namespace mrpt::serialization

namespace mrpt_ext
{
class RawlogReader;
class RawlogTranslator;

/// Long pauses between the records of a log.
struct LogGaps
{
  static constexpr double kLong = 10;  ///< [s]

  std::size_t count = 0;          ///< of gaps longer than that
  double begin = 0, longest = 0;  ///< [s] time of the longest one, and how long it is
  void add(double from, double to);
};

/// Contents of a log and their use; complete once the source has returned its last record.
struct RawlogStatistics
{
  std::size_t entries = 0;                               ///< records in the file
  std::map<std::string, ObservationCount> observations;  ///< by class, without namespace
  UnusableCounts unusable;                               ///< "<class>: <reason>": detections, or whole observations
  double first_time = 0, last_time = 0;                  ///< [s] of the records given; 0 when there were none
  LogGaps gaps;
  [[nodiscard]] double duration() const { return last_time - first_time; }
};

/// A rawlog of either form as plain records in order of time; see RawlogTranslator for how entries
/// become records. Damage, unknown classes, values beyond the physical limits (geometry/physical_limits.h) and times
/// that go back by more than kReorderWindow are an InputError (data): damaged compression at construction, the rest
/// when it is reached.
class RawlogSource
{
 public:
  static constexpr double kReorderWindow = 1;  ///< [s] a record may be this much older than the newest before it

  /// `step`: [s] that one step of a log of steps counts where its stamps are no clock, see stepClockOf(). Such a log is
  /// read once more, beforehand. `scans`: the labels of the sensors whose laser scans become records.
  explicit RawlogSource(const std::filesystem::path& path, double step = 1,
                        const std::function<bool(const std::string& label)>& scans = {});
  ~RawlogSource();

  /// The next record in time order; nothing at the end.
  [[nodiscard]] std::optional<Record> next();

  [[nodiscard]] RawlogStatistics statistics() const;
  /// The log consists of actions and sensory frames: one sensory frame is one frame, its readings have one time.
  [[nodiscard]] bool hasSensoryFrames() const { return has_sensory_frames_; }
  /// Time [s] of each sensory frame read so far that has one.
  [[nodiscard]] const std::vector<double>& frameTimes() const;
  /// Why the stamps of the log do not count; empty: they do.
  [[nodiscard]] const std::string& clockNote() const { return clock_note_; }
  [[nodiscard]] const std::string& sha256() const;
  [[nodiscard]] const std::string& comment() const;

  /// Time [s] of each action/sensory-frame pair read so far, by step; empty for an observation-only log.
  [[nodiscard]] const std::vector<double>& stepTimes() const;
  /// Step of the last record returned; nothing in an observation-only log.
  [[nodiscard]] std::optional<std::size_t> step() const { return step_; }

 private:
  void readEntry();
  void translate(const mrpt::serialization::CSerializable& entry);
  void push(Record record, std::optional<std::size_t> step);

  std::unique_ptr<RawlogReader> reader_;
  std::unique_ptr<RawlogTranslator> translator_;
  ReorderBuffer queue_;
  std::string clock_note_;
  bool has_sensory_frames_ = false;
  bool ended_ = false;
  std::optional<std::size_t> step_;
  std::optional<double> first_time_, last_time_;
  LogGaps gaps_;
};

/// All records of a source at once.
[[nodiscard]] std::vector<Record> readAll(RawlogSource& source);
}  // namespace mrpt_ext
