#include "mrpt_ext/evaluation/geometry_errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kOldest = 1.0;  // [s] of the frame that an error is explained by
constexpr int kRangeClasses = 6;

using Geometries = std::vector<FrameGeometry>;
/// Class of a frame, by its position in a list of classes; nothing when the quantity does not exist.
using Classify = std::function<std::optional<std::size_t>(const FrameGeometry&)>;

struct Quantity
{
  std::string name;
  std::vector<std::string> labels;
  Classify classify;
};

Quantity landmarksInView()
{
  return {"landmarks in view",
          {"1", "2", "3", "4", "5", "6", "7 to 9", "10 to 19", "20 or more"},
          [](const FrameGeometry& g) -> std::optional<std::size_t> {
            return g.landmarks < 7 ? g.landmarks - 1 : g.landmarks < 10 ? 6 : g.landmarks < 20 ? 7 : 8;
          }};
}

Quantity spreadOfLandmarks()
{
  return {"angle over which they spread [deg]",
          {"0 to 30", "30 to 60", "60 to 90", "90 to 120", "120 to 180", "180 to 360"},
          [](const FrameGeometry& g) -> std::optional<std::size_t>
          {
            if (!g.spread) return std::nullopt;
            const double degrees = radToDeg(*g.spread);
            return degrees < 120 ? static_cast<std::size_t>(degrees / 30) : degrees < 180 ? 4 : 5;
          }};
}

/// Steps of 1, 2 or 5 that cut the distances that occur into about kRangeClasses.
Quantity distanceOfLandmarks(const Geometries& frames)
{
  double farthest = 0;
  for (const FrameGeometry& frame : frames) farthest = std::max(farthest, frame.range.value_or(0));
  Quantity quantity{"their median distance [m]", {}, [](const FrameGeometry&) { return std::nullopt; }};
  if (!(farthest > 0) || !std::isfinite(farthest)) return quantity;
  const double decade = std::pow(10.0, std::floor(std::log10(farthest / kRangeClasses)));
  const double share = farthest / kRangeClasses / decade;
  const double step = decade * (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1);
  const auto text = [&](int i)
  {
    std::string digits = std::to_string(i * step);
    digits.resize(digits.find('.') + (step < 0.1 ? 3 : step < 1 ? 2 : 0));
    return digits;
  };
  for (int i = 0; i * step <= farthest; ++i) quantity.labels.push_back(text(i) + " to " + text(i + 1));
  quantity.classify = [step](const FrameGeometry& g) -> std::optional<std::size_t>
  {
    if (!g.range) return std::nullopt;
    return static_cast<std::size_t>(*g.range / step);
  };
  return quantity;
}

const FrameGeometry* frameOf(const Geometries& frames, double time)
{
  constexpr double kSameTime = 1e-6;
  const auto after = std::upper_bound(frames.begin(), frames.end(), time + kSameTime,
                                      [](double wanted, const FrameGeometry& frame) { return wanted < frame.time; });
  if (after == frames.begin() || (after - 1)->time < time - kOldest) return nullptr;
  return &*(after - 1);
}

double countedFrom(const RunContext& context, const RunScore& score)
{
  return context.start_time + score.converged_at_s.value_or(0);
}

/// Errors and answers of one method, class by class.
void addMethod(GeometryErrors& table, const Quantity& quantity, const Geometries& frames, const MethodTrack& track,
               const MethodScore& method, double from)
{
  std::vector<std::vector<double>> errors(table.classes.size());
  std::vector<std::size_t> answered(table.classes.size(), 0);
  for (const ErrorSample& error : method.errors)
  {
    if (error.stamp < from) continue;
    const FrameGeometry* frame = frameOf(frames, error.time);
    if (const auto c = frame ? quantity.classify(*frame) : std::nullopt) errors[*c].push_back(error.position_m);
  }
  std::set<double> answer_times;
  for (const TrackPoint& point : track.points) answer_times.insert(point.time);
  for (const FrameGeometry& frame : frames)
    if (const auto c = quantity.classify(frame); c && frame.time >= from && answer_times.contains(frame.time))
      ++answered[*c];
  for (std::size_t c = 0; c < table.classes.size(); ++c)
  {
    GeometryCell cell{errors[c].size(), {}, quantile(errors[c], 0.5), quantile(errors[c], 0.95)};
    if (const std::size_t n = table.classes[c].frames; n > 0)
      cell.answered = static_cast<double>(answered[c]) / static_cast<double>(n);
    table.classes[c].methods.push_back(cell);
  }
}

GeometryErrors tableOf(const Quantity& quantity, const RunContext& context, const RunRecord& record,
                       const RunScore& score)
{
  const double from = countedFrom(context, score);
  GeometryErrors table{quantity.name, {}};
  for (const std::string& label : quantity.labels) table.classes.push_back({label, 0, {}});
  for (const FrameGeometry& frame : context.geometry)
    if (const auto c = quantity.classify(frame); c && frame.time >= from) ++table.classes[*c].frames;
  for (std::size_t m = 0; m < score.methods.size(); ++m)
    addMethod(table, quantity, context.geometry, record.methods[m], score.methods[m], from);
  std::erase_if(table.classes, [](const GeometryClass& c) { return c.frames == 0; });
  return table;
}
}  // namespace

std::vector<GeometryErrors> errorsAgainstGeometry(const RunContext& context, const RunRecord& record,
                                                  const RunScore& score)
{
  std::vector<GeometryErrors> all;
  const bool judged = std::any_of(score.methods.begin(), score.methods.end(),
                                  [](const MethodScore& method) { return !method.errors.empty(); });
  if (!judged || record.methods.size() != score.methods.size()) return all;
  for (const Quantity& quantity : {landmarksInView(), spreadOfLandmarks(), distanceOfLandmarks(context.geometry)})
    if (GeometryErrors table = tableOf(quantity, context, record, score); !table.classes.empty())
      all.push_back(std::move(table));
  return all;
}
}  // namespace mrpt_ext
