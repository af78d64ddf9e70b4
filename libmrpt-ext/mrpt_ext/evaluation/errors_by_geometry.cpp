#include "mrpt_ext/evaluation/errors_by_geometry.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kOldest = 1.0;  // [s] age of the frame that an error is assigned to
constexpr int kRangeClasses = 6;

using Geometries = DiskBackedSequence<FrameGeometry>;
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
  return {"angular spread of the landmarks [deg]",
          {"0 to 30", "30 to 60", "60 to 90", "90 to 120", "120 to 180", "180 to 360"},
          [](const FrameGeometry& g) -> std::optional<std::size_t>
          {
            if (!g.spread) return std::nullopt;
            const double degrees = radToDeg(*g.spread);
            return degrees < 120 ? static_cast<std::size_t>(degrees / 30) : degrees < 180 ? 4 : 5;
          }};
}

/// Classes of equal width, 1, 2 or 5 times a power of ten, about kRangeClasses of them.
Quantity distanceOfLandmarks(const Geometries& frames)
{
  double farthest = 0;
  for (const FrameGeometry& frame : frames) farthest = std::max(farthest, frame.range.value_or(0));
  Quantity quantity{"median distance of the landmarks [m]", {}, [](const FrameGeometry&) { return std::nullopt; }};
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

/// Finds the frame of a time; times must ascend.
class FrameFinder
{
 public:
  explicit FrameFinder(const Geometries& frames) : next_(frames.begin()), end_(frames.end()) {}

  std::optional<FrameGeometry> at(double time)
  {
    constexpr double kSameTime = 1e-6;
    for (; next_ != end_ && next_->time <= time + kSameTime; ++next_) last_ = *next_;
    return last_ && last_->time >= time - kOldest ? last_ : std::nullopt;
  }

 private:
  Geometries::const_iterator next_, end_;
  std::optional<FrameGeometry> last_;
};

/// Whether the trajectory has an estimate at exactly a time; times must ascend.
class EstimateFinder
{
 public:
  explicit EstimateFinder(const MethodTrajectory& trajectory)
      : next_(trajectory.points.begin()), end_(trajectory.points.end())
  {
  }

  bool hasEstimateAt(double time)
  {
    while (next_ != end_ && next_->time < time) ++next_;
    return next_ != end_ && next_->time == time;
  }

 private:
  DiskBackedSequence<PoseEstimate>::const_iterator next_, end_;
};

double countedFrom(const RunContext& context, const RunScore& score)
{
  return context.start_time + score.converged_at_s.value_or(0);
}

/// Errors and number of estimates of one method, class by class.
void addMethod(ErrorsByGeometry& table, const Quantity& quantity, const Geometries& frames,
               const MethodTrajectory& trajectory, const MethodScore& method, double from)
{
  std::vector<std::vector<double>> errors(table.classes.size());
  std::vector<std::size_t> estimated(table.classes.size(), 0);
  FrameFinder finder(frames);
  for (const ErrorSample& error : method.errors)
  {
    if (error.stamp < from) continue;
    const auto frame = finder.at(error.time);
    if (const auto c = frame ? quantity.classify(*frame) : std::nullopt) errors[*c].push_back(error.position_m);
  }
  EstimateFinder estimates(trajectory);
  for (const FrameGeometry& frame : frames)
    if (const auto c = quantity.classify(frame); c && frame.time >= from && estimates.hasEstimateAt(frame.time))
      ++estimated[*c];
  for (std::size_t c = 0; c < table.classes.size(); ++c)
  {
    GeometryCell cell{errors[c].size(), {}, quantile(errors[c], 0.5), quantile(errors[c], 0.95)};
    if (const std::size_t n = table.classes[c].frames; n > 0)
      cell.estimated = static_cast<double>(estimated[c]) / static_cast<double>(n);
    table.classes[c].methods.push_back(cell);
  }
}

ErrorsByGeometry tableOf(const Quantity& quantity, const RunContext& context, const RunRecord& record,
                         const RunScore& score)
{
  const double from = countedFrom(context, score);
  ErrorsByGeometry table{quantity.name, {}};
  for (const std::string& label : quantity.labels) table.classes.push_back({label, 0, {}});
  for (const FrameGeometry& frame : context.geometry)
    if (const auto c = quantity.classify(frame); c && frame.time >= from) ++table.classes[*c].frames;
  for (std::size_t m = 0; m < score.methods.size(); ++m)
    addMethod(table, quantity, context.geometry, record.methods[m], score.methods[m], from);
  std::erase_if(table.classes, [](const GeometryClass& c) { return c.frames == 0; });
  return table;
}
}  // namespace

std::vector<ErrorsByGeometry> errorsByGeometry(const RunContext& context, const RunRecord& record,
                                               const RunScore& score)
{
  std::vector<ErrorsByGeometry> all;
  const bool judged = std::any_of(score.methods.begin(), score.methods.end(),
                                  [](const MethodScore& method) { return !method.errors.empty(); });
  if (!judged || record.methods.size() != score.methods.size()) return all;
  for (const Quantity& quantity : {landmarksInView(), spreadOfLandmarks(), distanceOfLandmarks(context.geometry)})
    if (ErrorsByGeometry table = tableOf(quantity, context, record, score); !table.classes.empty())
      all.push_back(std::move(table));
  return all;
}
}  // namespace mrpt_ext
