#include "mrpt_ext/correspondence/tree/interpretation_tree.h"

#include <algorithm>
#include <numeric>

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"
#include "mrpt_ext/correspondence/tree/interpretation_search.h"

namespace mrpt_ext
{
namespace
{
bool validOptions(const InterpretationOptions& o)
{
  const bool area = !o.area || (o.area->min.allFinite() && o.area->max.allFinite());
  const bool sigma = !o.std_bearing || (std::isfinite(*o.std_bearing) && *o.std_bearing > 0);
  const bool range = !o.max_range || (std::isfinite(*o.max_range) && *o.max_range > 0);
  const bool eps = std::isfinite(o.max_residual) && o.max_residual > 0;
  return area && sigma && range && eps && o.max_unmatched >= 0 && o.clutter_probability > 0 &&
         o.clutter_probability < 1;
}

bool validInput(std::span<const Vector2d> landmarks, std::span<const AnonymousBearing> bearings)
{
  const int count = static_cast<int>(landmarks.size());
  const auto known = [&](int index) { return index >= 0 && index < count; };
  return std::all_of(landmarks.begin(), landmarks.end(), [](const Vector2d& l) { return l.allFinite(); }) &&
         std::all_of(bearings.begin(), bearings.end(),
                     [&](const AnonymousBearing& b) {
                       return std::isfinite(b.bearing) && std::all_of(b.candidates.begin(), b.candidates.end(), known);
                     });
}

InterpretationProblem makeProblem(std::span<const Vector2d> landmarks, std::span<const AnonymousBearing> bearings,
                                  const InterpretationOptions& options)
{
  InterpretationProblem problem{landmarks, {}, {}, options};
  std::vector<int> everything(landmarks.size());
  std::iota(everything.begin(), everything.end(), 0);
  for (const AnonymousBearing& b : bearings)
  {
    problem.bearings.push_back(wrap(b.bearing));
    problem.allowed.push_back(b.candidates.empty() ? everything : b.candidates);
    std::vector<int>& list = problem.allowed.back();
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return problem;
}

/// True if `b` has all matches of `a` and more.
bool isPartOf(const Interpretation& a, const Interpretation& b)
{
  if (a.matched >= b.matched) return false;
  for (std::size_t i = 0; i < a.assignment.size(); ++i)
    if (a.assignment[i] >= 0 && a.assignment[i] != b.assignment[i]) return false;
  return true;
}

std::vector<Interpretation> withoutParts(std::vector<Interpretation> all)
{
  std::stable_sort(all.begin(), all.end(),
                   [](const Interpretation& a, const Interpretation& b) { return a.matched > b.matched; });
  std::vector<Interpretation> kept;
  for (Interpretation& candidate : all)
    if (std::none_of(kept.begin(), kept.end(), [&](const Interpretation& k) { return isPartOf(candidate, k); }))
      kept.push_back(std::move(candidate));
  return kept;
}
}  // namespace

Interpretations interpretBearings(std::span<const Vector2d> landmarks, std::span<const AnonymousBearing> bearings,
                                  const InterpretationOptions& options)
{
  Interpretations result;
  result.status = SolveStatus::bad_input;
  if (!validOptions(options) || !validInput(landmarks, bearings)) return result;
  const InterpretationProblem problem = makeProblem(landmarks, bearings, options);
  const int seen = static_cast<int>(bearings.size()), least = problem.minimumMatched();
  result.status = SolveStatus::too_few;
  if (seen < (options.allow_three ? 3 : 4)) return result;
  result.status = SolveStatus::none;
  if (static_cast<int>(landmarks.size()) < least) return result;

  InterpretationCandidates search = searchConsistent(problem);
  result.tested_by_depth = std::move(search.tested);
  result.valid_by_depth = std::move(search.valid);
  result.finished = search.finished;
  result.solutions = options.max_unmatched > 0 ? withoutParts(std::move(search.found)) : std::move(search.found);
  std::stable_sort(result.solutions.begin(), result.solutions.end(),
                   [](const Interpretation& a, const Interpretation& b)
                   { return a.log_likelihood > b.log_likelihood; });
  if (!result.solutions.empty()) result.status = SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
