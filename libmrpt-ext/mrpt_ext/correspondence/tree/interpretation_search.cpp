#include "mrpt_ext/correspondence/tree/interpretation_search.h"

#include <algorithm>

#include "mrpt_ext/correspondence/tree/interpretation_refinement.h"
#include "mrpt_ext/correspondence/tree/matching_order.h"
#include "mrpt_ext/correspondence/tree/ray_bundle.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kCostOfNode = 5, kCostOfRecord = 5000;  // operations

/// The pose of a prefix of matched bearings, and the candidates it leaves for the remaining ones.
struct Node
{
  RayCrossing base;
  std::vector<CrossedLandmark> children;             ///< of an open node: the next matches
  std::vector<std::vector<std::size_t>> candidates;  ///< of other nodes: per step of the order
  [[nodiscard]] bool open() const { return base.outcome == CrossingOutcome::open; }
};

class Search
{
 public:
  explicit Search(const InterpretationProblem& problem)
      : problem_(problem),
        options_(problem.options),
        covariance_(options_.gate == InterpretationGate::covariance),
        reach_(options_.max_range.value_or(std::numeric_limits<double>::infinity())),
        rays_(problem.landmarks, unitsOf(problem), std::tan(2 * std::min(options_.max_residual, 0.7)) / 2),
        nodes_(problem.bearings.size() + 1)
  {
    const std::size_t count = problem.bearings.size();
    for (Node& node : nodes_) node.candidates.resize(count);
    result_.tested.assign(count - 2, 0);
    result_.valid.assign(count - 2, 0);
    assignment_.assign(count, -1);
  }

  InterpretationCandidates run()
  {
    for (MatchingOrder& order : matchingOrders(problem_))
    {
      order_ = std::move(order);
      masks_.clear();
      for (const int bearing : order_.bearings)
      {
        masks_.emplace_back(rays_.size(), 0);
        for (const int l : allowed(bearing)) masks_.back()[static_cast<std::size_t>(l)] = -1;
      }
      matchFirst();
    }
    return std::move(result_);
  }

 private:
  struct Match
  {
    std::size_t step = 0, landmark = 0;
    InverseRay ray;
  };

  static std::vector<Vector2d> unitsOf(const InterpretationProblem& problem)
  {
    std::vector<Vector2d> units;
    for (const double b : problem.bearings) units.push_back(direction(b));
    return units;
  }

  [[nodiscard]] const std::vector<int>& allowed(int bearing) const
  {
    return problem_.allowed[static_cast<std::size_t>(bearing)];
  }
  [[nodiscard]] std::size_t bearingAt(std::size_t step) const
  {
    return static_cast<std::size_t>(order_.bearings[step]);
  }
  [[nodiscard]] bool isFree(std::size_t landmark) const
  {
    return std::none_of(matched_.begin(), matched_.end(), [&](const Match& m) { return m.landmark == landmark; });
  }
  /// True if the next match may come at this step.
  [[nodiscard]] bool mayStartAt(std::size_t step) const
  {
    const std::size_t skipped = step - matched_.size();
    return step < order_.bearings.size() && skipped <= (step > order_.skip_from ? order_.max_skipped : 0) &&
           result_.finished;
  }

  /// True if the bearing of this step may be one of `missing` unmatched ones.
  [[nodiscard]] bool mayMiss(std::size_t step, std::size_t missing) const
  {
    return step >= order_.skip_from && missing <= order_.max_skipped;
  }

  void push(std::size_t step, std::size_t landmark)
  {
    matched_.push_back({step, landmark, rays_.ray(bearingAt(step), landmark)});
    bearings_.push_back(
        {problem_.landmarks[landmark], problem_.bearings[bearingAt(step)], rays_.unit(bearingAt(step))});
    assignment_[bearingAt(step)] = static_cast<int>(landmark);
  }

  void pop()
  {
    assignment_[bearingAt(matched_.back().step)] = -1;
    matched_.pop_back();
    bearings_.pop_back();
  }

  void matchFirst()
  {
    for (std::size_t step = 0; mayStartAt(step); ++step)
      for (const int l : allowed(order_.bearings[step]))
      {
        if (!result_.finished) return;
        const auto landmark = static_cast<std::size_t>(l);
        rays_.setReference(bearingAt(step), landmark);
        setBounds(problem_.landmarks[landmark]);
        push(step, landmark);
        matchSecond(step + 1);
        pop();
      }
  }

  void setBounds(const Vector2d& reference)
  {
    constexpr double kEverywhere = std::numeric_limits<double>::infinity();
    const double widest = std::asin(std::min(1.0, kParallel * rays_.error())) + 4 * rays_.error();
    const double facing = widest < 1.5 ? std::tan(widest) : -1;
    bounds_ = {rays_.error(), facing, -kEverywhere, -kEverywhere, kEverywhere, kEverywhere};
    if (!options_.area) return;
    const Vector2d low = options_.area->min - reference, high = options_.area->max - reference;
    bounds_ = {rays_.error(), facing, low.x(), low.y(), high.x(), high.y()};
  }

  void matchSecond(std::size_t from)
  {
    for (std::size_t step = from; mayStartAt(step); ++step)
      for (const int l : allowed(order_.bearings[step]))
      {
        const auto landmark = static_cast<std::size_t>(l);
        if (!result_.finished) return;
        if (!isFree(landmark) || !withinReach(landmark)) continue;
        push(step, landmark);
        extend(step + 1);
        pop();
      }
  }

  /// Landmarks seen from one position are at most twice the range apart.
  [[nodiscard]] bool withinReach(std::size_t landmark) const
  {
    if (!std::isfinite(reach_)) return true;
    const Vector2d& position = problem_.landmarks[landmark];
    return std::all_of(bearings_.begin(), bearings_.end(),
                       [&](const MatchedBearing& m) { return (m.landmark - position).norm() <= 2 * reach_; });
  }

  /// Counts the free landmarks of a step as children of the present node; false when the budget is used up.
  bool countTested(std::size_t step)
  {
    std::size_t children = allowed(order_.bearings[step]).size();
    for (const Match& m : matched_) children -= masks_[step][m.landmark] != 0;
    WorkCounter::add(kCostOfNode * children);
    result_.tested[matched_.size() - 2] += children;
    total_ += children;
    const bool within = options_.budget == nullptr || options_.budget->spend(kCostOfNode * children);
    result_.finished = result_.finished && within && total_ <= options_.max_tested;
    return result_.finished;
  }

  /// Matches one of the bearings from this step on, or none of them.
  void extend(std::size_t from)
  {
    const bool open = nodes_[matched_.size()].open();
    for (std::size_t step = from; mayStartAt(step); ++step)
    {
      if (!countTested(step)) return;
      open ? extendOpen(step) : extendClosed(step);
    }
    const std::size_t skipped = order_.bearings.size() - matched_.size();
    const bool rest_skipped = from == order_.bearings.size() || from >= order_.skip_from;
    if (rest_skipped && skipped >= order_.least_skipped && skipped <= order_.max_skipped) record();
  }

  void extendOpen(std::size_t step)
  {
    Node& parent = nodes_[matched_.size()];
    rays_.cross(matched_[1].ray, bearingAt(step), bounds_, masks_[step], parent.children);
    for (const CrossedLandmark& child : parent.children) tryMatch(parent, step, child.landmark, child.crossing);
  }

  void extendClosed(std::size_t step)
  {
    const Node& parent = nodes_[matched_.size()];
    for (const std::size_t l : parent.candidates[step])
      tryMatch(parent, step, l, crossRays(matched_[1].ray, rays_.ray(bearingAt(step), l), bounds_));
  }

  /// `crossing`: of the second ray with the new one.
  void tryMatch(const Node& parent, std::size_t step, std::size_t landmark, const RayCrossing& crossing)
  {
    if (!isFree(landmark) || !withinReach(landmark)) return;
    push(step, landmark);
    if (evaluate(parent, crossing, step + 1))
    {
      ++result_.valid[matched_.size() - 3];
      extend(step + 1);
    }
    pop();
  }

  /// Computes the node of a prefix from its parent; false when it cannot lead to a solution.
  bool evaluate(const Node& parent, const RayCrossing& with_second, std::size_t next_step)
  {
    Node& here = nodes_[matched_.size()];
    here.base = with_second;
    if (matched_.size() == 3) return here.open() || (withinRange(here.base) && findCandidates(here, next_step));
    if (!crossWithAll(parent, here, with_second)) return false;
    if (here.open()) return true;
    if (!parent.open()) return filterCandidates(parent, here, next_step);
    return findCandidates(here, next_step) && (crossings_.size() == 1 || filterCandidates(here, here, next_step));
  }

  /// Crosses the newest ray with the others, and keeps the pose with the smallest bound. Every crossing must be
  /// consistent with all matches.
  bool crossWithAll(const Node& parent, Node& here, const RayCrossing& with_second)
  {
    here.base = parent.base;
    crossings_.clear();
    for (std::size_t i = 1; i + 1 < matched_.size(); ++i)
    {
      const RayCrossing c = i == 1 ? with_second : crossRays(matched_[i].ray, matched_.back().ray, bounds_);
      if (c.outcome == CrossingOutcome::none) return false;
      if (c.outcome == CrossingOutcome::open) continue;
      if (!agreesWithMatched(c) || !withinRange(c)) return false;
      crossings_.push_back(c);
      if (here.open() || c.shift < here.base.shift) here.base = c;
    }
    return true;
  }

  [[nodiscard]] DirectionGate gate(const RayCrossing& base, const InverseRay& ray) const
  {
    return covariance_ ? gateAt<true>(base, rays_.error(), ray.px, ray.py)
                       : gateAt<false>(base, rays_.error(), ray.px, ray.py);
  }

  /// All bearings matched so far agree with the pose.
  [[nodiscard]] bool agreesWithMatched(const RayCrossing& base) const
  {
    return std::all_of(matched_.begin() + 1, matched_.end(),
                       [&](const Match& m) { return gate(base, m.ray).admits(m.ray.ux, m.ray.uy); });
  }

  [[nodiscard]] bool withinRange(const RayCrossing& base) const
  {
    if (!std::isfinite(reach_)) return true;
    const Vector2d robot = bearings_[0].landmark + Vector2d(base.x, base.y);
    return std::all_of(bearings_.begin(), bearings_.end(),
                       [&](const MatchedBearing& m) { return (m.landmark - robot).norm() <= reach_ + base.slack; });
  }

  /// The joint test: enough of the remaining bearings have a landmark within the gate.
  bool findCandidates(Node& here, std::size_t next_step)
  {
    rays_.openGates(here.base, covariance_, reach_);
    for (const Match& m : matched_) rays_.closeGate(m.landmark);
    std::size_t missing = next_step - matched_.size();
    for (std::size_t step = next_step; step < order_.bearings.size(); ++step)
    {
      rays_.admit(bearingAt(step), masks_[step], here.candidates[step]);
      if (here.candidates[step].empty() && !mayMiss(step, ++missing)) return false;
    }
    return true;
  }

  /// The same from the candidates of the parent that are consistent with all new crossings.
  bool filterCandidates(const Node& parent, Node& here, std::size_t next_step)
  {
    std::size_t missing = next_step - matched_.size();
    for (std::size_t step = next_step; step < order_.bearings.size(); ++step)
    {
      kept_.clear();
      for (const std::size_t l : parent.candidates[step])
      {
        if (l == matched_.back().landmark) continue;
        const InverseRay ray = rays_.ray(bearingAt(step), l);
        if (std::all_of(crossings_.begin(), crossings_.end(),
                        [&](const RayCrossing& c) { return gate(c, ray).admits(ray.ux, ray.uy); }))
          kept_.push_back(l);
      }
      here.candidates[step] = kept_;
      if (kept_.empty() && !mayMiss(step, ++missing)) return false;
    }
    return true;
  }

  void record()
  {
    const RayCrossing& base = nodes_[matched_.size()].base;
    if (options_.budget != nullptr) options_.budget->spend(kCostOfRecord);
    if (auto found = refineInterpretation(problem_, assignment_, bearings_, base))
      result_.found.push_back(std::move(*found));
  }

  const InterpretationProblem& problem_;
  const InterpretationOptions& options_;
  MatchingOrder order_;
  bool covariance_;
  double reach_;
  RayBundle rays_;
  CrossingBounds bounds_;
  std::vector<RayBundle::Mask> masks_;  ///< landmarks allowed, per step of the order
  std::vector<Node> nodes_;             ///< by number of matched bearings
  std::vector<RayCrossing> crossings_;  ///< of the newest ray with the others
  std::vector<std::size_t> kept_;
  std::vector<Match> matched_;
  std::vector<MatchedBearing> bearings_;  ///< of the matches
  std::vector<int> assignment_;
  InterpretationCandidates result_;
  std::uint64_t total_ = 0;
};
}  // namespace

InterpretationCandidates searchConsistent(const InterpretationProblem& problem) { return Search(problem).run(); }
}  // namespace mrpt_ext
