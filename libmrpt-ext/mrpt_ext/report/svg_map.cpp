#include "mrpt_ext/report/svg_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/landmark_quality.h"
#include "mrpt_ext/report/map_view.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/svg_shapes.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxNames = 80;   // more ids would hide the map
constexpr std::size_t kMaxDots = 1500;  // per method
constexpr std::size_t kMaxTrajectoryPoints = 6000;
constexpr double kResolution = 1.5;  // drawing units between points of a trajectory
constexpr double kJump = 0.08;       // of the map's width, between two estimates

/// Splits a trajectory at gaps in time and where the estimate jumped, so that no line is drawn where the robot did not
/// drive.
template <typename Points, typename Position>
std::string trajectoryShape(const Points& points, Position position, double max_gap, const MapView& view,
                            const std::string& css_class)
{
  if (points.empty()) return {};
  const auto thinned = [&](const SvgPoints& part)
  { return thinnedPath(part, kResolution, 50 + kMaxTrajectoryPoints * part.size() / points.size()); };
  std::string svg;
  SvgPoints part;
  double time_before = 0;
  for (const auto& point : points)
  {
    const Vector2d drawn = view.draw(position(point));
    const bool gap = !part.empty() && max_gap > 0 && point.time - time_before > max_gap;
    const bool jumped = !part.empty() && (drawn - part.back()).norm() > kJump * view.width();
    if (gap || jumped)
    {
      svg += svgPolyline(thinned(part), css_class);
      part.clear();
    }
    part.push_back(drawn);
    time_before = point.time;
  }
  return svg + svgPolyline(thinned(part), css_class);
}

std::string landmarkShapes(const LandmarkTable& map, const std::map<std::string, LandmarkScore>& scores,
                           const MapView& view)
{
  std::string svg;
  for (const Landmark& landmark : shownLandmarks(map, scores))
  {
    const Vector2d p = view.draw(landmark.position.head<2>());
    std::string name = landmark.id == kNoId ? std::string() : std::to_string(landmark.id);
    const auto score = scores.find(name);
    const bool warned = score != scores.end() && !landmarkWarning(score->second).empty();
    std::string tip = name.empty() ? "anonymous landmark" : "landmark " + name;
    if (!landmark.category.empty()) tip += ", " + landmark.category;
    svg += "<path class=\"landmark" + std::string(warned ? " warned" : "") + "\" d=\"M" + svgNumber(p.x()) + " " +
           svgNumber(p.y() - 5.5) + "l5.5 10h-11z\">" + element("title", "", escapeHtml(tip)) + "</path>";
    if (!name.empty() && map.size() <= kMaxNames) svg += svgText({p.x() + 8, p.y() + 4}, "start", "id", name);
    svg += "\n";
  }
  return svg;
}

std::string modeShape(const ModeSummary& mode, const MapView& view)
{
  const Vector2d p = view.draw(mode.pose.mean.position());
  const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(mode.pose.covariance.topLeftCorner<2, 2>());
  const Vector2d radii = 2 * axes.eigenvalues().cwiseMax(0).cwiseSqrt() * view.scale();
  const Vector2d major = axes.eigenvectors().col(1);
  const Vector2d nose = p + 13 * Vector2d(std::cos(mode.pose.mean.phi), -std::sin(mode.pose.mean.phi));
  const std::string percent = percentText(mode.weight);
  return "<ellipse class=\"mode\" cx=\"" + svgNumber(p.x()) + "\" cy=\"" + svgNumber(p.y()) + "\" rx=\"" +
         svgNumber(std::max(3.0, radii[1])) + "\" ry=\"" + svgNumber(std::max(3.0, radii[0])) +
         "\" transform=\"rotate(" + svgNumber(-radToDeg(std::atan2(major.y(), major.x()))) + " " + svgNumber(p.x()) +
         " " + svgNumber(p.y()) + ")\">" + element("title", "", "mode with weight " + escapeHtml(percent)) +
         "</ellipse>" + svgLine(p, nose, "mode-heading") + svgText({p.x(), p.y() - 9}, "middle", "id", percent) + "\n";
}

std::string scaleBar(const MapView& view)
{
  const double length = niceStep(view.width() / view.scale() / 4), x = 14, y = view.height() - 14;
  const double end = x + length * view.scale();
  return "<path class=\"scale\" d=\"M" + svgNumber(x) + " " + svgNumber(y - 5) + "v5H" + svgNumber(end) + "v-5\"/>" +
         svgText({0.5 * (x + end), y - 8}, "middle", "", niceText(length, length) + " m") + "\n";
}

/// Oracles are in the table only; dead reckoning is drawn only where it is aligned with the truth.
bool isDrawn(const MethodTrajectory& method, const RunScore& score)
{
  if (method.oracle || method.points.empty()) return false;
  if (method.name != kOdometryMethod) return true;
  return std::any_of(score.methods.begin(), score.methods.end(),
                     [](const MethodScore& m) { return m.name == kOdometryMethod && !m.errors.empty(); });
}

std::span<const TimedPose> truthWithinLog(const RunContext& context)
{
  const auto isBefore = [](const TimedPose& pose, double time) { return pose.time < time; };
  const auto isAfter = [](double time, const TimedPose& pose) { return time < pose.time; };
  const auto first = std::lower_bound(context.truth.begin(), context.truth.end(), context.start_time, isBefore);
  const double end = context.start_time + context.duration_s;
  return {first, std::upper_bound(first, context.truth.end(), end, isAfter)};
}

std::string methodShapes(const RunRecord& record, const RunScore& score, const MapView& view)
{
  const auto position = [](const PoseEstimate& p) { return p.pose.mean.position(); };
  const std::vector<std::string> names = methodNames(score.methods);
  std::string below, above;
  for (const MethodTrajectory& method : record.methods)
  {
    if (!isDrawn(method, score)) continue;
    const std::string colour = methodClass(method.name, names);
    if (method.continuous)
    {
      above += trajectoryShape(method.points, position, 0, view, colour);
      continue;
    }
    SvgPoints dots;
    const std::size_t stride = method.points.size() / kMaxDots + 1;
    std::size_t i = 0;
    for (const PoseEstimate& point : method.points)
      if (const Vector2d p = view.draw(position(point)); i++ % stride == 0 && view.contains(p)) dots.push_back(p);
    below += svgDots(dots, colour);
  }
  return below + above;
}

std::string endShapes(const RunRecord& record, const MapView& view)
{
  const MethodTrajectory* judged = judgedMethod(record);
  if (!judged || judged->points.empty()) return {};
  const Vector2d start = view.draw(judged->points.front().pose.mean.position());
  const Vector2d end = view.draw(judged->points.back().pose.mean.position());
  return "<circle class=\"start\" r=\"6\" cx=\"" + svgNumber(start.x()) + "\" cy=\"" + svgNumber(start.y()) +
         "\"><title>first estimate</title></circle><rect class=\"end\" width=\"11\" height=\"11\" x=\"" +
         svgNumber(end.x() - 5.5) + "\" y=\"" + svgNumber(end.y() - 5.5) + "\"><title>last estimate</title></rect>\n";
}

std::string legend(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  std::vector<LegendEntry> entries;
  if (!context.map.empty()) entries.push_back({"landmark", "triangle", "landmark"});
  if (!context.truth.empty()) entries.push_back({"truth", "line", "ground truth"});
  for (const MethodTrajectory& method : record.methods)
  {
    if (!isDrawn(method, score)) continue;
    const std::string symbol = method.name == kOdometryMethod ? "dash" : method.continuous ? "line" : "dot";
    entries.push_back({methodClass(method.name, methodNames(score.methods)), symbol, method.name});
  }
  if (const MethodTrajectory* judged = judgedMethod(record); judged && !judged->points.empty())
  {
    entries.push_back({"", "ring", "first estimate"});
    entries.push_back({"", "square", "last estimate"});
  }
  if (!record.filter.modes_at_end.empty()) entries.push_back({"mode", "ring", "final modes, 2 sigma"});
  return htmlLegend(entries);
}

std::string outsideNote(const RunRecord& record, const RunScore& score, const MapView& view)
{
  std::size_t outside = 0;
  for (const MethodTrajectory& method : record.methods)
    for (const PoseEstimate& point : method.points)
      outside += isDrawn(method, score) && !view.contains(view.draw(point.pose.mean.position())) ? 1 : 0;
  if (outside == 0) return {};
  return element("p", "note", std::to_string(outside) + " estimates are outside of this view.") + "\n";
}
std::string thinnedNote(const RunContext& context, const RunScore& score)
{
  const std::size_t shown = shownLandmarks(context.map, score.landmarks).size(), all = context.map.size();
  if (shown == all) return {};
  return element("p", "note", std::to_string(shown) + " of " + std::to_string(all) + " landmarks are drawn.") + "\n";
}
}  // namespace

std::string svgMap(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const MapView view = viewOf(context, judgedMethod(record));
  const double truth_gap = context.truth_is_sparse ? 0 : 2;  // [s]
  std::string svg = "<svg class=\"map\" role=\"img\" viewBox=\"0 0 " + svgNumber(view.width()) + " " +
                    svgNumber(view.height()) +
                    "\"><title>Map with landmarks, ground truth and the estimates of all methods</title>\n";
  svg += methodShapes(record, score, view);
  svg += trajectoryShape(
      truthWithinLog(context), [](const TimedPose& p) { return p.pose.position(); }, truth_gap, view, "truth");
  svg += landmarkShapes(context.map, score.landmarks, view) + endShapes(record, view);
  for (const ModeSummary& mode : record.filter.modes_at_end) svg += modeShape(mode, view);
  svg += scaleBar(view) + "</svg>\n";
  return svg + legend(context, record, score) + outsideNote(record, score, view) + thinnedNote(context, score);
}
}  // namespace mrpt_ext
