#include "mrpt_ext/solvers/minimal_solvers.h"

#include <algorithm>

#include "mrpt_ext/solvers/line_of_position.h"
#include "mrpt_ext/solvers/three_bearing_pose.h"
#include "mrpt_ext/solvers/three_bearing_pose_noncentral.h"

namespace mrpt_ext
{
namespace
{
using Rows = std::span<const PoseResidual>;

constexpr std::size_t kAllTriplesUpTo = 5;  // bearings: of more, only some triples are tried
constexpr std::size_t kTriples = 5;
constexpr std::size_t kRanges = 4, kLines = 3;  // loci of each kind
constexpr std::size_t kAngles = 3;              // bearings: with more, their triples do
constexpr std::size_t kPoints = 16;             // landmarks that enter the rigid fit
constexpr int kHeadings = 12;
constexpr int kRounds = 4;

/// The first row from `start` on, around the end, whose landmark is none of `others`; the row at `start` when all are.
const PoseResidual& nextOther(Rows rows, std::size_t start, std::span<const PoseResidual* const> others)
{
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const PoseResidual& row = rows[(start + k) % rows.size()];
    if (std::none_of(others.begin(), others.end(), [&](const PoseResidual* o) { return o->landmark == row.landmark; }))
      return row;
  }
  return rows[start % rows.size()];
}

/// At most `most` rows, evenly spread, of different landmarks while there are any.
std::vector<const PoseResidual*> someOf(Rows rows, std::size_t most)
{
  const std::size_t count = std::min(rows.size(), most);
  std::vector<const PoseResidual*> some;
  some.reserve(count);
  for (std::size_t k = 0; k < count; ++k) some.push_back(&nextOther(rows, k * rows.size() / count, some));
  return some;
}

class Proposer
{
 public:
  Proposer(const PoseResiduals& rows, std::vector<PoseGuess>& seeds) : rows_(rows), seeds_(seeds)
  {
    const double share = 1 / static_cast<double>(std::max<std::size_t>(1, rows.sightings().size()));
    for (const PoseResidual& m : rows.sightings())
    {
      reference_ += share * m.offset;
      same_position_ = same_position_ && m.offset == rows.sightings().front().offset;
    }
  }

  void fromTriples()
  {
    const Rows b = rows_.bearings();
    const std::size_t n = b.size();
    if (n < 3) return;
    if (n > kAllTriplesUpTo)
    {
      for (std::size_t t = 0; t < kTriples; ++t)
      {
        const std::size_t i = t * n / kTriples;
        std::array<const PoseResidual*, 2> members{&b[i], &b[i]};
        members[1] = &nextOther(b, i + n / 3, members);
        fromTriple(b[i], *members[1], nextOther(b, i + 2 * (n / 3) + t % 2, members));
      }
      return;
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k) fromTriple(b[i], b[j], b[k]);
  }

  /// Rigid fit of the landmarks seen with range and bearing by one sensor.
  void fromPoints()
  {
    struct Point
    {
      Vector2d world, robot;
      double weight;
    };
    std::vector<Point> points;
    Vector2d world = Vector2d::Zero(), robot = Vector2d::Zero();
    double sum = 0;
    for (const PoseResidual* r : someOf(rows_.ranges(), kPoints))
      for (const PoseResidual& b : rows_.bearings())
        if (b.landmark == r->landmark && b.offset == r->offset)
        {
          const double w = 1 / (square(1 / r->weight) + square(r->range / b.weight));
          points.push_back({r->landmark, r->offset + r->range * b.unit, w});
          world += w * points.back().world;
          robot += w * points.back().robot;
          sum += w;
          break;
        }
    if (points.size() < 2) return;
    world /= sum;
    robot /= sum;
    Vector2d turn = Vector2d::Zero();
    for (const Point& p : points)
    {
      const Vector2d from = p.robot - robot, to = p.world - world;
      turn += p.weight * Vector2d(from.dot(to), cross(from, to));
    }
    if (!(turn.squaredNorm() > 0)) return;
    const Vector2d heading = turn.normalized();
    propose(world - PoseResiduals::turned(robot, heading), heading);
  }

  /// Crossings of circles and lines.
  void fromLoci()
  {
    std::vector<Source> sources;
    for (const PoseResidual* r : someOf(rows_.ranges(), kRanges)) sources.push_back({Source::Kind::range, r});
    if (!rows_.headings().empty())
      for (const PoseResidual* b : someOf(rows_.bearings(), kLines)) sources.push_back({Source::Kind::line, b});
    for (std::size_t i = 0; i < sources.size(); ++i)
      for (std::size_t j = i + 1; j < sources.size(); ++j) fromPair(sources[i], sources[j]);
    if (sources.empty() || rows_.bearings().size() > kAngles) return;
    const Rows seen = rows_.bearings();
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (std::size_t j = i + 1; j < seen.size(); ++j)
        for (const Source& source : sources) fromPair({Source::Kind::angle, &seen[i], &seen[j]}, source);
  }

 private:
  void fromTriple(const PoseResidual& a, const PoseResidual& b, const PoseResidual& c)
  {
    if (same_position_)
    {
      const auto seen = [](const PoseResidual& m) {
        return VisibleLandmark<double>{m.landmark.x(), m.landmark.y(), m.unit.x(), m.unit.y()};
      };
      const ThreeBearingPose<double> triple = solveThreeBearingPose(seen(a), seen(b), seen(c));
      if (triple.outcome != ThreeBearingOutcome::pose) return;
      const Vector2d heading(triple.c, triple.s);
      propose(Vector2d(triple.x, triple.y) - PoseResiduals::turned(a.offset, heading), heading);
      return;
    }
    const NoncentralThreeBearingPose triple = solveNoncentralThreeBearingPose(
        {{{a.landmark, a.offset, a.unit}, {b.landmark, b.offset, b.unit}, {c.landmark, c.offset, c.unit}}});
    for (int k = 0; k < triple.count; ++k)
    {
      const Pose2& pose = triple.poses[static_cast<std::size_t>(k)];
      propose(pose.position(), direction(pose.phi));
    }
  }

  /// A measurement that gives a line of position for the robot's reference point.
  struct Source
  {
    enum class Kind
    {
      range,
      line,  ///< a bearing under the known heading
      angle  ///< between two bearings
    };
    Kind kind;
    const PoseResidual* first;
    const PoseResidual* second = nullptr;
  };

  /// The landmark moved so that the reference point sees it as the sensor does, on a robot with this heading.
  [[nodiscard]] Vector2d asSeenFromReference(const PoseResidual& m, const Vector2d& heading) const
  {
    return m.landmark - PoseResiduals::turned(m.offset - reference_, heading);
  }

  [[nodiscard]] std::optional<PositionLocus> locusOf(const Source& source, const Vector2d& heading) const
  {
    const PoseResidual& m = *source.first;
    const Vector2d landmark = asSeenFromReference(m, heading);
    switch (source.kind)
    {
      case Source::Kind::range:
        return circleAbout(landmark, m.range);
      case Source::Kind::line:
        return lineThrough(landmark, PoseResiduals::turned(m.unit, heading));
      case Source::Kind::angle:
        return circleOfAngle(landmark, asSeenFromReference(*source.second, heading), m.unit, source.second->unit);
    }
    return std::nullopt;
  }

  [[nodiscard]] LocusCrossing crossing(const Source& a, const Source& b, const Vector2d& heading) const
  {
    const auto locus_a = locusOf(a, heading), locus_b = locusOf(b, heading);
    return locus_a && locus_b ? crossLoci(*locus_a, *locus_b) : LocusCrossing{};
  }

  /// Heading that bearings and compass ask for on average, if the reference point is there; zero when nothing does.
  [[nodiscard]] Vector2d headingAt(const Vector2d& position, const Vector2d& guess) const
  {
    Vector2d sum = Vector2d::Zero();
    for (const PoseResidual& b : rows_.bearings())
    {
      const Vector2d d = asSeenFromReference(b, guess) - position;
      const double r = d.norm();
      if (r > 0) sum += square(b.weight) / r * Vector2d(b.unit.dot(d), cross(b.unit, d));
    }
    for (const PoseResidual& h : rows_.headings()) sum += square(h.weight) * h.unit;
    return sum.squaredNorm() > 0 ? sum.normalized() : sum;
  }

  /// Both crossings of two loci. With sensors at different positions the loci depend on the heading, which is corrected
  /// in a few iterations.
  void fromPair(const Source& a, const Source& b)
  {
    if (rows_.bearings().empty() && rows_.headings().empty())
    {
      for (int k = 0; k < kHeadings; ++k)
      {
        const Vector2d heading = direction(kTwoPi * k / kHeadings);
        const LocusCrossing there = crossing(a, b, heading);
        for (int c = 0; c < there.count; ++c) proposeReference(there.points[static_cast<std::size_t>(c)], heading);
      }
      return;
    }
    const Vector2d compass = rows_.headings().empty() ? Vector2d(1, 0) : rows_.headings().front().unit;
    for (std::size_t side = 0; side < 2; ++side)
    {
      std::optional<Vector2d> position;
      Vector2d heading = compass;
      for (int round = 0; round < (same_position_ ? 1 : kRounds); ++round)
      {
        const LocusCrossing there = crossing(a, b, heading);
        if (static_cast<std::size_t>(there.count) <= side) break;
        position = there.points[side];
        heading = headingAt(*position, heading);
      }
      if (position) proposeReference(*position, heading);
    }
  }

  void proposeReference(const Vector2d& point, const Vector2d& heading)
  {
    propose(point - PoseResiduals::turned(reference_, heading), heading);
  }

  void propose(const Vector2d& position, const Vector2d& heading)
  {
    const double cost = rows_.roughCost(position, heading);
    if (std::isfinite(cost)) seeds_.push_back({{position.x(), position.y(), angleOf(heading)}, cost});
  }

  const PoseResiduals& rows_;
  std::vector<PoseGuess>& seeds_;
  Vector2d reference_{0, 0};   ///< mean position of the sensors, robot axes
  bool same_position_ = true;  ///< all measurements were taken there
};
}  // namespace

std::vector<PoseGuess> solveMinimalSubsets(const PoseResiduals& rows, std::size_t most)
{
  std::vector<PoseGuess> seeds;
  seeds.reserve(16);
  Proposer proposer(rows, seeds);
  proposer.fromTriples();
  proposer.fromPoints();
  proposer.fromLoci();
  const auto better = [](const PoseGuess& a, const PoseGuess& b) { return a.rough_cost < b.rough_cost; };
  const std::size_t kept = std::min(most, seeds.size());
  std::partial_sort(seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(kept), seeds.end(), better);
  seeds.resize(kept);
  return seeds;
}
}  // namespace mrpt_ext
