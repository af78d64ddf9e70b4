#include "mrpt_ext/experiment/clock_check.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
/// [s] of a clock.
struct TimeSpan
{
  double from = 0, to = 0;
};

std::string spanText(const TimeSpan& span) { return formatted("%.1f to %.1f s", span.from, span.to); }

/// What to suspect where one clock runs a power of a thousand faster than the other (durations alike within 20 %).
std::string unitHint(const std::string& name, const TimeSpan& span, const TimeSpan& other)
{
  struct Unit
  {
    double per_second;
    const char* name;
  };
  for (const Unit& unit : {Unit{1e3, "milliseconds"}, Unit{1e6, "microseconds"}, Unit{1e9, "nanoseconds"}})
    if (std::abs((span.to - span.from) / unit.per_second / (other.to - other.from) - 1) < 0.2)
      return "; the times of the " + name + " look like " + unit.name + ", expected seconds";
  return {};
}

/// The same for either of them.
std::string unitHint(const std::string& a_name, const TimeSpan& a, const std::string& b_name, const TimeSpan& b)
{
  return unitHint(a_name, a, b) + unitHint(b_name, b, a);
}

/// Length of the part of `of` that `other` has in common with it; negative: the gap between them.
double common(const TimeSpan& of, const TimeSpan& other)
{
  return std::min(of.to, other.to) - std::max(of.from, other.from);
}

std::optional<TimeSpan> spanOfDetections(const RunContext& context)
{
  if (context.geometry.empty()) return std::nullopt;
  return TimeSpan{context.geometry.front().time, context.geometry.back().time};
}

void checkOdometry(LocalizationInput& input, const TimeSpan& detections)
{
  const Trajectory& odometry = input.context.odometry;
  if (odometry.size() < 2 || input.config.frames.independent) return;
  const TimeSpan measured{odometry.front().time, odometry.back().time};
  const std::string hint = unitHint("detections", detections, "odometry", measured);
  const double shared = common(detections, measured), length = detections.to - detections.from;
  if (shared < 0)
    throw dataError(input.context.rawlog_path + ": odometry has the times " + spanText(measured) +
                    ", the detections have " + spanText(detections) +
                    ": expected one clock, correct the stamps of one of them" +
                    formatted(" (the starts are %.1f s apart)", detections.from - measured.from) + hint);
  if (shared < 0.9 * length)
    input.notes.push_back(
        formatted("odometry covers only %.0f %% of the time of the detections: ", 100 * shared / length) +
        spanText(measured) + " of " + spanText(detections) + hint);
}

void noteJumps(LocalizationInput& input)
{
  const OdometryJumps& jumps = input.log.overview.odometry.jumps();
  if (jumps.count() == 0) return;
  input.notes.push_back("odometry jumps " + countOf(jumps.count(), "time") +
                        formatted(", by up to %.1f m, %.1f s after the start: no robot drives like that; what it drove "
                                  "in the meantime is not known",
                                  jumps.longest(), jumps.timeOfLongest() - input.context.start_time));
}

void checkTruth(const LocalizationInput& input)
{
  const RunContext& context = input.context;
  const bool whole_log = input.log.window.start == 0 && !input.log.window.duration;
  if (context.truth.empty() || !whole_log) return;
  const TimeSpan log{context.start_time, context.start_time + context.duration_s},
      truth{context.truth.front().time, context.truth.back().time};
  if (common(log, truth) < 0)
    throw dataError("the ground truth has the times " + spanText(truth) + ", the log " + context.rawlog_path + " has " +
                    spanText(log) + ": expected one clock, correct the stamps of the truth" +
                    unitHint("truth", truth, "log", log));
}
}  // namespace

void checkClocks(LocalizationInput& input)
{
  checkTruth(input);
  noteJumps(input);
  if (const auto detections = spanOfDetections(input.context)) checkOdometry(input, *detections);
}
}  // namespace mrpt_ext
