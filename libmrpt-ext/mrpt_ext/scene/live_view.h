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

/// A window that follows a run: map, particles, modes and what is measured at the moment.
///
/// Drawing has a thread of its own and shows the newest moment; moments that come faster than it can draw are left out.
/// The run itself is slowed to `speed` times the time of its log, so that a person can follow, for as long as the
/// window is open. Results do not depend on it.
class LiveView
{
 public:
  /// Opens the window. When that cannot be (no display, built without MRPT's windows) it says so on `err` in one line
  /// and shows nothing; the run goes on as if it had not been asked for.
  LiveView(const LandmarkTable& map, double speed, std::ostream& err);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  [[nodiscard]] bool isOpen() const;
  /// Shows a moment of the log; returns when it is due.
  void show(PlaybackStep step);
  /// Returns when the user has closed the window.
  void waitUntilClosed() const;

 private:
  using Clock = std::chrono::steady_clock;
  void drawUntilDone();

  const LandmarkTable& map_;
  double speed_;
  std::unique_ptr<SceneWindow> window_;
  std::optional<std::pair<double, Clock::time_point>> start_;  // the first moment, by the log and by our clock
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PlaybackStep> next_;
  bool done_ = false;
  std::thread drawing_;
};
}  // namespace mrpt_ext
