#pragma once

#include <chrono>
#include <condition_variable>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
class SceneWindow;

/// A window that follows a run: map, particles, modes and present detections.
///
/// Its own thread draws the latest step; steps that arrive faster than it draws are skipped.
/// The run itself is slowed to `speed` times the time of its log, while the window is open. Results do not depend on
/// it.
class LiveView
{
 public:
  /// Opens the window. If that is impossible (no display, built without MRPT's windows), it prints one line on `err`
  /// and shows nothing; the run continues.
  LiveView(const LandmarkTable& map, double speed, std::ostream& err);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  [[nodiscard]] bool isOpen() const;
  /// Shows a step; returns when its time has come.
  void show(PlaybackStep step);
  /// Returns when the user has closed the window.
  void waitUntilClosed() const;

 private:
  using Clock = std::chrono::steady_clock;
  void drawUntilDone();

  const LandmarkTable& map_;
  double speed_;
  std::unique_ptr<SceneWindow> window_;
  std::optional<std::pair<double, Clock::time_point>> start_;  // time of the first step in the log and by the clock
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PlaybackStep> next_;
  bool done_ = false;
  std::thread drawing_;
};
}  // namespace mrpt_ext
