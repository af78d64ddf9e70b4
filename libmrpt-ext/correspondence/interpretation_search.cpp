#include "mrpt_ext/correspondence/interpretation_search.h"

#include <algorithm>
#include <array>

#include "mrpt_ext/correspondence/bearing_prefix.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "mrpt_ext/solvers/bearing_triple.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
/// The prefix with a given number of matched bearings, and what it predicts for every landmark.
struct Node
{
  bool open = true;  ///< no reliable pose yet
  BearingPrefix prefix;
  std::vector<double> predicted, gate;  ///< per landmark [rad]; gate < 0: not visible from there
};

class Search
{
 public:
  explicit Search(const InterpretationProblem& problem)
      : problem_(problem),
        options_(problem.options),
        error_(problem.options.max_residual),
        order_(spreadOrder(problem)),
        used_(problem.landmarks.size(), false),
        assignment_(problem.bearings.size(), -1),
        nodes_(problem.bearings.size() + 1)
  {
    for (const double b : problem.bearings) units_.push_back(direction(b));
    result_.tested.assign(problem.bearings.size() - 2, 0);
    result_.valid.assign(problem.bearings.size() - 2, 0);
    for (Node& node : nodes_)
    {
      node.predicted.assign(problem.landmarks.size(), 0);
      node.gate.assign(problem.landmarks.size(), -1);
    }
  }

  InterpretationCandidates run()
  {
    extend(0);
    return std::move(result_);
  }

 private:
  [[nodiscard]] int matchedCount() const { return static_cast<int>(matched_.size()); }
  [[nodiscard]] Node& node() { return nodes_[matched_.size()]; }
  [[nodiscard]] const Vector2d& position(int landmark) const
  {
    return problem_.landmarks[static_cast<std::size_t>(landmark)];
  }

  /// Matches, or leaves out, the bearing at `place` of the order.
  void extend(std::size_t place)
  {
    if (!result_.finished) return;
    if (place == order_.size())
    {
      finish();
      return;
    }
    const int bearing = order_[place];
    for (const int landmark : problem_.allowed[static_cast<std::size_t>(bearing)])
      if (!used_[static_cast<std::size_t>(landmark)]) match(place, bearing, landmark);
    const int later = static_cast<int>(order_.size() - place) - 1;
    if (matchedCount() + later >= problem_.minimumMatched()) extend(place + 1);
  }

  void match(std::size_t place, int bearing, int landmark)
  {
    const std::size_t depth = matched_.size() + 1;
    if (depth >= 3)
    {
      ++result_.tested[depth - 3];
      result_.finished = ++total_ <= options_.max_tested;
      if (!withinGate(bearing, landmark)) return;
    }
    push(bearing, landmark);
    if (withinReach() && (depth < 3 || settle(place)))
    {
      if (depth >= 3) ++result_.valid[depth - 3];
      extend(place + 1);
    }
    pop(bearing, landmark);
  }

  void push(int bearing, int landmark)
  {
    used_[static_cast<std::size_t>(landmark)] = true;
    assignment_[static_cast<std::size_t>(bearing)] = landmark;
    matched_.push_back({position(landmark), problem_.bearings[static_cast<std::size_t>(bearing)]});
    matched_units_.push_back(units_[static_cast<std::size_t>(bearing)]);
  }

  void pop(int bearing, int landmark)
  {
    matched_units_.pop_back();
    matched_.pop_back();
    assignment_[static_cast<std::size_t>(bearing)] = -1;
    used_[static_cast<std::size_t>(landmark)] = false;
  }

  /// The prediction of the prefix before this bearing, when it has one.
  bool withinGate(int bearing, int landmark)
  {
    if (matchedCount() < 3 || node().open) return true;
    const std::size_t l = static_cast<std::size_t>(landmark);
    const double b = problem_.bearings[static_cast<std::size_t>(bearing)];
    return node().gate[l] >= 0 && std::abs(wrap(node().predicted[l] - b)) <= node().gate[l];
  }

  /// Landmarks seen from one place are at most twice the range apart.
  [[nodiscard]] bool withinReach() const
  {
    if (!options_.max_range) return true;
    return std::all_of(matched_.begin(), matched_.end(),
                       [&](const MatchedBearing& m)
                       { return (m.landmark - matched_.back().landmark).norm() <= 2 * *options_.max_range; });
  }

  /// Computes the node of the present prefix; false when it cannot lead to a solution.
  bool settle(std::size_t place)
  {
    Node& here = node();
    if (matched_.size() == 3 && !possibleOrder()) return false;
    const Node& before = nodes_[matched_.size() - 1];
    here.open = true;
    if (matched_.size() > 3 && !before.open)
    {
      updatePrefix(here.prefix, matched_, before.prefix.pose, error_);
      here.open = !here.prefix.reliable;
    }
    else if (!decideByTriple(here))
      return false;
    if (here.open) return true;
    const double worst = static_cast<double>(matched_.size()) * square(error_);
    if (here.prefix.sse > 1.05 * worst || !poseAllowed(here.prefix)) return false;
    predictAll(here);
    return enoughToCome(place);
  }

  /// Looks for a triple with the newest bearing that has a reliable pose which explains the others; the node stays open
  /// when there is none. False when a triple contradicts the bearings.
  bool decideByTriple(Node& here)
  {
    const std::size_t last = matched_.size() - 1;
    for (std::size_t i = 0; i < last; ++i)
      for (std::size_t j = i + 1; j < last; ++j)
      {
        const BearingTriple triple =
            solveBearingTriple({matched_[i].landmark, matched_[j].landmark, matched_[last].landmark},
                               {matched_units_[i], matched_units_[j], matched_units_[last]}, error_);
        if (triple.outcome == BearingTriple::Outcome::behind) return false;
        if (triple.outcome == BearingTriple::Outcome::open) continue;
        const Pose2 pose{triple.position.x(), triple.position.y(), triple.phi};
        if (matched_.size() == 3)
          updatePrefix(here.prefix, matched_, pose, error_);
        else if (!refineTriple(here, {matched_[i], matched_[j], matched_[last]}, pose))
          return false;
        here.open = !here.prefix.reliable;
        if (!here.open) return true;
      }
    return true;
  }

  /// Checks all matched bearings against the pose of a reliable triple and refines it with them.
  bool refineTriple(Node& here, const std::vector<MatchedBearing>& triple, const Pose2& pose)
  {
    updatePrefix(here.prefix, triple, pose, error_);
    if (!here.prefix.reliable) return true;
    for (const MatchedBearing& m : matched_)
    {
      const Vector2d d = m.landmark - here.prefix.pose.position();
      const double innovation = wrap(angleOf(d) - here.prefix.pose.phi - m.bearing);
      if (std::abs(innovation) > gateAt(here.prefix, d, error_, options_.gate)) return false;
    }
    updatePrefix(here.prefix, matched_, here.prefix.pose, error_);
    return true;
  }

  /// With no gap of pi between three bearings the robot stands inside the triangle, which then has their order.
  [[nodiscard]] bool possibleOrder() const
  {
    const double g1 = wrap(matched_[1].bearing - matched_[0].bearing);
    const double g2 = wrap(matched_[2].bearing - matched_[1].bearing);
    const double g3 = wrap(matched_[0].bearing - matched_[2].bearing);
    const double limit = kPi - 2 * error_;
    const bool ccw = g1 > 0 && g2 > 0 && g3 > 0, cw = g1 < 0 && g2 < 0 && g3 < 0;
    const bool inside = (ccw || cw) && std::max({std::abs(g1), std::abs(g2), std::abs(g3)}) < limit;
    if (!inside) return true;
    const double area = cross(matched_[1].landmark - matched_[0].landmark, matched_[2].landmark - matched_[0].landmark);
    return ccw ? area > 0 : area < 0;
  }

  [[nodiscard]] bool poseAllowed(const BearingPrefix& prefix) const
  {
    const double slack = 2 * prefix.shift;
    if (options_.area)
    {
      const Vector2d p = prefix.pose.position();
      const Vector2d margin(slack, slack);
      if ((p + margin - options_.area->min).minCoeff() < 0 || (options_.area->max + margin - p).minCoeff() < 0)
        return false;
    }
    if (!options_.max_range) return true;
    return std::all_of(matched_.begin(), matched_.end(),
                       [&](const MatchedBearing& m)
                       { return (m.landmark - prefix.pose.position()).norm() <= *options_.max_range + slack; });
  }

  void predictAll(Node& here) const
  {
    for (std::size_t l = 0; l < problem_.landmarks.size(); ++l)
    {
      here.gate[l] = -1;
      if (used_[l]) continue;
      const Vector2d d = problem_.landmarks[l] - here.prefix.pose.position();
      if (options_.max_range && d.norm() > *options_.max_range + 2 * here.prefix.shift) continue;
      here.predicted[l] = angleOf(d) - here.prefix.pose.phi;
      here.gate[l] = gateAt(here.prefix, d, error_, options_.gate);
    }
  }

  /// The joint test: enough of the bearings after `place` have a landmark within the gate.
  bool enoughToCome(std::size_t place)
  {
    int possible = matchedCount();
    for (std::size_t k = place + 1; k < order_.size(); ++k)
    {
      const std::vector<int>& allowed = problem_.allowed[static_cast<std::size_t>(order_[k])];
      if (std::any_of(allowed.begin(), allowed.end(), [&](int l) { return withinGate(order_[k], l); })) ++possible;
    }
    return possible >= problem_.minimumMatched();
  }

  void finish()
  {
    if (matchedCount() < problem_.minimumMatched()) return;
    Pose2 start = node().prefix.pose;
    if (node().open)
    {
      std::vector<KnownBearing> known;
      for (const MatchedBearing& m : matched_) known.push_back({m.landmark, m.bearing, 1});
      const PoseMl fit = solveBearingPoseMl(known);
      if (fit.status != SolveStatus::ok) return;
      start = fit.pose.mean;
    }
    if (std::optional<Interpretation> found = judgeInterpretation(problem_, assignment_, start))
      result_.found.push_back(std::move(*found));
  }

  const InterpretationProblem& problem_;
  const InterpretationOptions& options_;
  double error_;
  std::vector<int> order_;
  std::vector<bool> used_;
  std::vector<int> assignment_;
  std::vector<Node> nodes_;  ///< by number of matched bearings
  std::vector<Vector2d> units_, matched_units_;
  std::vector<MatchedBearing> matched_;
  InterpretationCandidates result_;
  std::uint64_t total_ = 0;
};
}  // namespace

InterpretationCandidates searchConsistent(const InterpretationProblem& problem) { return Search(problem).run(); }
}  // namespace mrpt_ext
