#include "mrpt_ext/vision/stereo/floor_junctions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
const double kLeastSine = std::sin(degToRad(35));  ///< of the angle between lines that meet
constexpr double kArmReach = 0.025;                ///< [m] lines may end before they meet, beside three pixels
constexpr double kFitReach = 0.02;    ///< [m] points around the meeting that are fitted again, beside five pixels
constexpr double kLineOff = 0.005;    ///< [m] a point may be off its line, beside half a pixel
constexpr double kArmStart = 0.003;   ///< [m] from the meeting, beside two and a half pixels
constexpr double kArmLength = 0.025;  ///< [m] and at least four pixels
constexpr double kArmOff = 0.003;     ///< [m] a point may be off an arm, beside three quarters of a pixel
constexpr double kArmRadius = 0.2;    ///< [m] of the tightest arc
constexpr double kArmBin = 0.003;     ///< [m] and at least 1.3 pixels
constexpr double kThere = 0.6, kMissing = 0.3;  ///< shares of an arm's bins
constexpr double kDirectionOff = degToRad(15);  ///< beside what the point's gradients allow
constexpr double kBorder = 2;                   ///< [px]
constexpr double kStep = 1e-4;                  ///< [m] of a numerical derivative

enum class Arm
{
  there,
  missing,
  unclear,
  outside  ///< beyond the image
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// True if a line in this direction may run through the point.
bool mayRun(const MarkingPoint& point, const Eigen::Vector2d& direction, double beside = 0)
{
  const double a = std::atan2(point.along_a.y(), point.along_a.x());
  const double b = std::atan2(point.along_b.y(), point.along_b.x());
  const double half = 0.5 * std::remainder(b - a, kPi);
  const double off = std::remainder(std::atan2(direction.y(), direction.x()) - (a + half), kPi);
  return std::abs(off) <= std::abs(half) + beside;
}

struct Line
{
  Eigen::Vector2d middle, direction;
  double std_across = 0;  ///< [m]
};

class JunctionFinder
{
 public:
  JunctionFinder(const FloorMarkings& markings, const StereoCamera& camera, const MarkingSettings& settings)
      : markings_(markings), camera_(camera), settings_(settings)
  {
  }

  [[nodiscard]] std::vector<FloorJunction> find() const
  {
    std::vector<FloorJunction> found;
    const auto& stripes = markings_.stripes;
    for (std::size_t i = 0; i < stripes.size(); ++i)
    {
      for (std::size_t j = i + 1; j < stripes.size(); ++j) keep(found, between(stripes[i], stripes[j]));
      for (const FloorLine& wall : markings_.walls) keep(found, atWall(stripes[i], wall));
    }
    return found;
  }

 private:
  /// One junction per position; the one with more arms wins.
  void keep(std::vector<FloorJunction>& found, const std::optional<FloorJunction>& junction) const
  {
    if (!junction) return;
    const Eigen::Vector2d size = camera_.footprintAt(junction->position);
    for (FloorJunction& other : found)
    {
      const Eigen::Vector2d d = other.position - junction->position;
      if (std::abs(d.x()) > 0.015 + 3 * size.x() || std::abs(d.y()) > 0.015 + 3 * size.y()) continue;
      if (junction->kind > other.kind || (junction->kind == other.kind && junction->std_u < other.std_u))
        other = *junction;
      return;
    }
    found.push_back(*junction);
  }

  [[nodiscard]] static bool reaches(const FloorLine& line, const Eigen::Vector2d& position,
                                    const Eigen::Vector2d& footprint)
  {
    const double along = line.direction.dot(position - line.middle);
    const double reach = kArmReach + 3 * pixelAlong(footprint, line.direction);
    return along > line.first - reach && along < line.last + reach;
  }

  [[nodiscard]] std::optional<Eigen::Vector2d> meeting(const Line& a, const Line& b) const
  {
    const double sine = cross(a.direction, b.direction);
    if (std::abs(sine) < kLeastSine) return std::nullopt;
    const Eigen::Vector2d position = a.middle + cross(b.middle - a.middle, b.direction) / sine * a.direction;
    if (!(position.x() > 0) || position.norm() > settings_.max_range) return std::nullopt;
    const auto pixel = camera_.pixelOf(position);
    if (!pixel || !inside(*pixel)) return std::nullopt;
    return position;
  }
  [[nodiscard]] bool inside(const cv::Point2d& p) const
  {
    return p.x >= kBorder && p.y >= kBorder && p.x <= camera_.size.width - 1 - kBorder &&
           p.y <= camera_.size.height - 1 - kBorder;
  }

  /// The line through the points of `line` near `position`; as it was with too few.
  [[nodiscard]] Line fitNear(const Eigen::Vector2d& position, const Line& line,
                             const std::vector<MarkingPoint>& points) const
  {
    const Eigen::Vector2d footprint = camera_.footprintAt(position);
    const double reach = kFitReach + 5 * pixelAlong(footprint, line.direction);
    const double off = kLineOff + 0.5 * pixelAcross(footprint, line.direction);
    Eigen::Vector2d sum(0, 0);
    double xx = 0, xy = 0, yy = 0;
    int n = 0;
    for (const MarkingPoint& p : points)
    {
      const Eigen::Vector2d d = p.position - position;
      if (std::abs(line.direction.dot(d)) > reach) continue;
      if (std::abs(cross(line.direction, p.position - line.middle)) > off || !mayRun(p, line.direction)) continue;
      sum += d, xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y(), ++n;
    }
    if (n < 4) return {line.middle, line.direction, pixelAcross(footprint, line.direction)};
    const Eigen::Vector2d mean = sum / n;
    xx -= n * square(mean.x()), xy -= n * mean.x() * mean.y(), yy -= n * square(mean.y());
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy), spread = std::hypot(xx - yy, 2 * xy);
    const double along = line.direction.dot(mean), length = 0.5 * (xx + yy + spread);
    const double scatter = std::max(0.0, 0.5 * (xx + yy - spread)) / (n - 2);
    const double by_points = scatter * (1.0 / n + square(along) / length);
    const double floor = settings_.std_line * pixelAcross(footprint, line.direction);
    return {position + mean, {std::cos(angle), std::sin(angle)}, std::sqrt(by_points + square(floor))};
  }

  [[nodiscard]] Arm arm(const Eigen::Vector2d& position, const Eigen::Vector2d& direction,
                        const std::vector<MarkingPoint>& points) const
  {
    const Eigen::Vector2d footprint = camera_.footprintAt(position);
    const double pixel = pixelAlong(footprint, direction), across = pixelAcross(footprint, direction);
    const double start = kArmStart + 2.5 * pixel, bin = std::max(kArmBin, 1.3 * pixel);
    const auto bins = static_cast<std::size_t>(std::max(3.0, std::ceil(std::max(kArmLength, 4 * pixel) / bin)));
    std::vector<char> seen(bins, 0);
    for (const MarkingPoint& p : points)
    {
      const Eigen::Vector2d d = p.position - position;
      const double along = direction.dot(d);
      if (along < start || along >= start + bin * static_cast<double>(bins)) continue;
      const double off = kArmOff + 0.75 * across + square(along) / (2 * kArmRadius);
      if (std::abs(cross(direction, d)) > off || !mayRun(p, direction, kDirectionOff)) continue;
      seen[static_cast<std::size_t>((along - start) / bin)] = 1;
    }
    std::size_t visible = 0, hits = 0;
    for (std::size_t i = 0; i < bins; ++i)
    {
      const auto at = camera_.pixelOf(position + (start + bin * (static_cast<double>(i) + 0.5)) * direction);
      if (!at || !inside(*at)) continue;
      ++visible, hits += static_cast<std::size_t>(seen[i]);
    }
    if (visible < 3) return Arm::outside;
    const double share = static_cast<double>(hits) / static_cast<double>(visible);
    return share >= kThere ? Arm::there : share <= kMissing ? Arm::missing : Arm::unclear;
  }

  /// Two lines that reach their meeting, fitted again to the points near it.
  struct Meeting
  {
    Line a, b;
    Eigen::Vector2d position;
  };
  [[nodiscard]] std::optional<Meeting> meetingOf(const FloorLine& first, const FloorLine& second,
                                                 const std::vector<MarkingPoint>& points_of_second) const
  {
    Line a{first.middle, first.direction, 0}, b{second.middle, second.direction, 0};
    auto position = meeting(a, b);
    if (!position || !reaches(first, *position, camera_.footprintAt(*position)) ||
        !reaches(second, *position, camera_.footprintAt(*position)))
      return std::nullopt;
    a = fitNear(*position, a, markings_.points.stripes), b = fitNear(*position, b, points_of_second);
    position = meeting(a, b);
    if (!position) return std::nullopt;
    return Meeting{a, b, *position};
  }

  [[nodiscard]] std::optional<FloorJunction> between(const FloorLine& first, const FloorLine& second) const
  {
    const auto found = meetingOf(first, second, markings_.points.stripes);
    if (!found) return std::nullopt;
    const auto& [a, b, position] = *found;
    int arms_a = 0, arms_b = 0;
    bool complete = true;
    for (const auto& [line, arms] : {std::pair(&a, &arms_a), std::pair(&b, &arms_b)})
      for (const double sign : {1.0, -1.0})
      {
        const Arm seen = arm(position, sign * line->direction, markings_.points.stripes);
        if (seen == Arm::unclear) return std::nullopt;
        *arms += seen == Arm::there;
        complete = complete && seen != Arm::outside;
      }
    if (arms_a == 0 || arms_b == 0) return std::nullopt;
    const int arms = arms_a + arms_b;
    const JunctionKind kind = arms == 4 ? JunctionKind::crossing : arms == 3 ? JunctionKind::tee : JunctionKind::corner;
    return made(position, kind, complete, a, b);
  }

  [[nodiscard]] std::optional<FloorJunction> atWall(const FloorLine& stripe, const FloorLine& wall) const
  {
    const auto found = meetingOf(stripe, wall, markings_.points.walls);
    if (!found) return std::nullopt;
    const auto& [a, b, position] = *found;
    // The marking comes from the side on which the camera is.
    const Eigen::Vector2d normal(-b.direction.y(), b.direction.x());
    const bool away = (normal.dot(a.direction) > 0) == (normal.dot(b.middle) > 0);
    if (arm(position, away ? Eigen::Vector2d(-a.direction) : a.direction, markings_.points.stripes) != Arm::there)
      return std::nullopt;
    const Arm one = arm(position, b.direction, markings_.points.walls),
              other = arm(position, -b.direction, markings_.points.walls);
    const auto fits = [](Arm seen) { return seen == Arm::there || seen == Arm::outside; };
    if (!fits(one) || !fits(other) || (one == Arm::outside && other == Arm::outside)) return std::nullopt;
    return made(position, JunctionKind::tee, true, a, b);
  }

  [[nodiscard]] FloorJunction made(const Eigen::Vector2d& position, JunctionKind kind, bool complete, const Line& a,
                                   const Line& b) const
  {
    const cv::Point2d pixel = *camera_.pixelOf(position);
    // A line that is off by e moves the meeting by e / sine along the other one.
    const double sine = std::abs(cross(a.direction, b.direction));
    const auto columns = [&](const Eigen::Vector2d& step)
    {
      const auto moved = camera_.pixelOf(position + kStep * step.normalized());
      return moved ? (moved->x - pixel.x) / kStep : 0.0;
    };
    const double by_a = columns(b.direction) * a.std_across / sine, by_b = columns(a.direction) * b.std_across / sine;
    return {kind, position, pixel, std::hypot(by_a, by_b), complete};
  }

  const FloorMarkings& markings_;
  const StereoCamera& camera_;
  const MarkingSettings& settings_;
};
}  // namespace

const char* nameOf(JunctionKind kind)
{
  return kind == JunctionKind::corner ? "L" : kind == JunctionKind::tee ? "T" : "X";
}

FloorMarkings findFloorJunctions(const cv::Mat& whiteness, const StereoCamera& camera, const MarkingSettings& settings)
{
  FloorMarkings markings;
  markings.points = findMarkingPoints(whiteness, camera, settings);
  markings.stripes = findFloorLines(markings.points.stripes, settings.max_range);
  markings.walls = findFloorLines(markings.points.walls, settings.max_range);
  markings.junctions = JunctionFinder(markings, camera, settings).find();
  return markings;
}
}  // namespace mrpt_ext
