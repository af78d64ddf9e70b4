#include "mrpt_ext/app/live_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>

#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/app/live_messages.h"
#include "mrpt_ext/configuration/configured_files.h"
#include "mrpt_ext/experiment/elapsed_time.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;
using SteadyClock = std::chrono::steady_clock;
constexpr std::size_t kLongestLine = 1 << 22;  // [bytes]

/// Latencies, in equal ratios from a microsecond to a minute: as exact as needed, in bounded memory.
class LatencyHistogram
{
 public:
  void add(double milliseconds)
  {
    largest_ = std::max(largest_, milliseconds);
    const double place = kPerDecade * std::log10(std::max(milliseconds, kLeast) / kLeast);
    ++counts_[std::min(counts_.size() - 1, static_cast<std::size_t>(place))];
    ++total_;
  }
  /// [ms], 2 % too long at most; 0 without any.
  [[nodiscard]] double quantile(double probability) const
  {
    std::size_t below = 0;
    for (std::size_t k = 0; k < counts_.size(); ++k)
      if ((below += counts_[k]) > 0 && static_cast<double>(below) >= probability * static_cast<double>(total_))
        return std::min(largest_, kLeast * std::pow(10, static_cast<double>(k + 1) / kPerDecade));
    return 0;
  }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  static constexpr double kLeast = 1e-3, kPerDecade = 120;
  std::vector<std::size_t> counts_ = std::vector<std::size_t>(960);
  std::size_t total_ = 0;
  double largest_ = 0;
};

/// One run over the lines of a stream.
class LiveRun
{
 public:
  LiveRun(const OnlineOptions& options, const LandmarkTable& map, std::ostream& out)
      : biases_(options.filter.biases), robot_(options, map), out_(out)
  {
  }

  void take(const std::string& line)
  {
    const auto started = SteadyClock::now();
    ++lines_;
    if (line.find_first_not_of(" \t\r") == std::string::npos) return;
    try
    {
      if (line.size() >= kLongestLine)
        throw dataError("longer than " + std::to_string(kLongestLine) + " bytes, expected one object per line");
      applyLiveLine(line, robot_);
    }
    catch (const InputError& error)
    {
      ++errors_;
      out_ << liveErrorLine(lines_, error.what()) << std::endl;
    }
    do write(robot_.estimates(), started);
    while (robot_.working());  // the lines to come wait in the pipe
  }

  int finish()
  {
    write(robot_.finish(), SteadyClock::now());
    Json end{{"lines", lines_}, {"errors", errors_}, {"estimates", estimates_}, {"verdict", toString(verdict_)}};
    end["latency_ms"] = {
        {"median", latencies_.quantile(0.5)}, {"p99", latencies_.quantile(0.99)}, {"max", latencies_.largest()}};
    end["late"] = {{"estimates", late_estimates_}, {"most_steps", most_steps_late_}};
    end["unusable"] = Json::object();
    for (const auto& [reason, count] : robot_.unusable()) end["unusable"][reason] = count;
    out_ << Json{{"end", end}}.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
    if (errors_ > 0) return kExitFailed;
    return verdict_ == Verdict::lost ? kExitLost : kExitDone;
  }

 private:
  void write(const std::vector<OnlineEstimate>& estimates, SteadyClock::time_point started)
  {
    for (const OnlineEstimate& estimate : estimates)
    {
      const double latency = millisecondsSince(started);
      out_ << liveLineOf(estimate, biases_, latency) << std::endl;
      latencies_.add(latency);
      verdict_ = estimate.verdict;
      ++estimates_;
      if (estimate.steps_late > 0) ++late_estimates_;
      most_steps_late_ = std::max(most_steps_late_, estimate.steps_late);
    }
  }

  BiasModel biases_;
  OnlineLocalizer robot_;
  std::ostream& out_;
  std::size_t lines_ = 0, errors_ = 0, estimates_ = 0;
  std::size_t late_estimates_ = 0, most_steps_late_ = 0;
  Verdict verdict_ = Verdict::ambiguous;
  LatencyHistogram latencies_;
};

/// The next line without its end, at most kLongestLine of it; false at the end of the stream.
bool readLine(std::istream& in, std::string& line)
{
  line.clear();
  std::streambuf& buffer = *in.rdbuf();
  for (int c = buffer.sbumpc(); c != std::char_traits<char>::eof(); c = buffer.sbumpc())
  {
    if (c == '\n') return true;
    if (line.size() < kLongestLine) line += static_cast<char>(c);
  }
  return !line.empty();
}
}  // namespace

int runLive(const Settings& settings, std::istream& in, std::ostream& out)
{
  const LandmarkTable map = configuredMap(settings);
  LiveRun run(onlineOptions(localizationConfig(settings, map)), map, out);
  for (std::string line; readLine(in, line);) run.take(line);
  return run.finish();
}
}  // namespace mrpt_ext
