#include "mrpt_ext/app/run_summary_text.h"

#include <algorithm>

#include "mrpt_ext/experiment/frame_bounds.h"
#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
std::string joined(const std::vector<std::string>& names)
{
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

std::string mapText(const RunContext& context)
{
  const auto [low, high] = context.map.boundingBox();
  return "map      " + countOf(context.map.size(), "landmark") +
         formatted(" in %.1f x %.1f m\n", high.x() - low.x(), high.y() - low.y());
}

std::string gapText(const LocalizationInput& input)
{
  const LogGaps& gaps = input.gaps;
  constexpr std::size_t kRecordsPerGap = 100;  // fewer: a log that is slow, not one with pauses
  const bool hours = gaps.longest > 3600;
  if (gaps.count == 0 || (!hours && kRecordsPerGap * gaps.count > input.context.rawlog_entries)) return {};
  return formatted(
      "gap      %zu of more than %.0f s without a record; the longest, %.1f %s, begins %.1f s after the start\n",
      gaps.count, LogGaps::kLong, hours ? gaps.longest / 3600 : gaps.longest, hours ? "h" : "s",
      gaps.begin - input.context.start_time);
}

std::string truthText(const RunContext& context)
{
  if (context.truth.empty()) return "truth    none: no errors are computed\n";
  return formatted("truth    %zu poses%s\n", context.truth.size(),
                   context.truth_is_sparse ? ", sparse: errors at their own stamps" : "");
}
}  // namespace

std::string inputText(const LocalizationInput& input)
{
  const RunContext& context = input.context;
  std::string result = mapText(context);
  result += "log      " + context.rawlog_path;
  result += formatted(": %zu records, %.1f s\n", context.rawlog_entries, context.duration_s);
  for (const auto& [name, count] : context.observations)
  {
    result += formatted("         %6zu ", count.total) + name;
    if (count.used == 0)
      result += " (ignored: no likelihood for this class)";
    else if (count.ignored > 0)
      result += formatted(", %zu of them ignored", count.ignored);
    result += "\n";
  }
  for (const auto& [reason, count] : input.unusable)
    result += formatted("         %6zu unusable: ", count) + reason + "\n";
  result += gapText(input);
  for (const std::string& label : input.unmatched_sensors)
    result += "         [Sensor_" + label + "] applies to no record, the log has sensors " +
              joined(input.logged_sensors) + "\n";
  for (const std::string& note : input.notes) result += "note     " + note + "\n";
  result += formatted("frames   %zu, %zu detections\n", input.log.frames, input.log.detections);
  return result + truthText(context);
}

std::string boundText(const LocalizationInput& input)
{
  std::string result;
  for (const auto& [what, name] :
       {std::pair(BoundOf::bearings, "bearings alone"), std::pair(BoundOf::everything, "all measurements")})
    if (const auto bound = boundOfFrames(streamOf(input), input.context.map, input.context.truth, what))
      result += formatted("limit    Cramer-Rao bound of %s: position RMSE %.3f m, median %.3f m (%zu frames)\n", name,
                          bound->position_rmse, bound->position_median, bound->frames);
  return result;
}

std::string verdictText(const RunRecord& record, double start_time)
{
  std::string result;
  std::optional<Verdict> before;
  for (const MethodTrajectory& method : record.methods)
    for (const PoseEstimate& point : method.points)
    {
      if (method.name != "particle_filter") break;
      if (before != point.verdict)
        result +=
            formatted("%8.1f s %-9s x %.2f m, y %.2f m, heading %.1f deg, %s, weight %.2f\n", point.time - start_time,
                      toString(point.verdict), point.pose.mean.x, point.pose.mean.y, radToDeg(point.pose.mean.phi),
                      countOf(static_cast<std::size_t>(point.modes), "mode").c_str(), point.best_weight);
      before = point.verdict;
    }
  return result;
}

std::string ambiguityText(const RunRecord& record, double start_time)
{
  const auto filter = std::find_if(record.methods.begin(), record.methods.end(),
                                   [](const MethodTrajectory& m) { return m.name == "particle_filter"; });
  if (filter == record.methods.end() || filter->points.empty()) return {};
  const auto& points = filter->points;
  const auto unique =
      std::find_if(points.begin(), points.end(), [](const PoseEstimate& p) { return p.verdict == Verdict::ok; });
  std::string result = formatted("start    %d pose hypothes%s after the first frame\n", points.front().modes,
                                 points.front().modes == 1 ? "is" : "es");
  if (unique == points.end()) return result + "unique   never: the filter did not reach `ok`\n";
  return result + formatted("unique   after %.1f s, at x %.2f m, y %.2f m, heading %.1f deg\n",
                            unique->time - start_time, unique->pose.mean.x, unique->pose.mean.y,
                            radToDeg(unique->pose.mean.phi));
}
}  // namespace mrpt_ext
