#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

namespace mrpt_ext
{
/// "localizing 40 %, 12 s left"; the time left is shown after the first second. `fraction` in [0, 1], `elapsed` [s].
[[nodiscard]] std::string progressText(const std::string& task, double fraction, double elapsed);

/// One line on stderr that shows how far a run is; silent when stderr is not a terminal or `enabled` is false.
class ProgressLine
{
 public:
  explicit ProgressLine(bool enabled, std::string task);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `fraction` in [0, 1]; redraws at most ten times a second.
  void show(double fraction);
  /// Wipes the line, e.g. before a message.
  void clear();

 private:
  bool enabled_;
  bool drawn_ = false;
  std::string task_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
};
}  // namespace mrpt_ext
