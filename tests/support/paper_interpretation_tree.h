#pragma once

#include <algorithm>

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
class PaperSearch
{
 public:
  PaperSearch(const InterpretationProblem& problem, bool in_order)
      : problem_(problem), in_order_(in_order), used_(problem.landmarks.size(), false)
  {
    result_.tested.assign(problem.bearings.size() - 2, 0);
    result_.valid.assign(problem.bearings.size() - 2, 0);
  }

  InterpretationCandidates run()
  {
    extend({});
    return std::move(result_);
  }

 private:
  /// Tries every free landmark for the next bearing; `prefix` is the pose of those matched so far.
  void extend(const BearingPoseLinear& prefix)
  {
    const std::size_t next = matched_.size();
    if (next == problem_.bearings.size())
    {
      record(prefix);
      return;
    }
    for (const int landmark : problem_.allowed[next])
    {
      if (used_[static_cast<std::size_t>(landmark)] || !result_.finished) continue;
      if (in_order_ && !fitsOrder(landmark)) continue;
      descend(prefix, landmark);
    }
  }

  void descend(const BearingPoseLinear& prefix, int landmark)
  {
    const std::size_t index = static_cast<std::size_t>(landmark), depth = matched_.size() + 1;
    const double bearing = problem_.bearings[matched_.size()];
    const Vector2d& position = problem_.landmarks[index];
    if (depth >= 3 && !count(result_.tested[depth - 3])) return;
    if (depth > 3 && std::abs(wrap(predictBearing(prefix.pose, position) - bearing)) > problem_.options.max_residual)
      return;
    used_[index] = true;
    matched_.push_back({position, bearing, problem_.stdBearing()});
    assignment_.push_back(landmark);
    const BearingPoseLinear pose = depth >= 3 ? solveBearingPoseLinear(matched_) : BearingPoseLinear{};
    if (depth < 3 || pose.status == SolveStatus::ok)
    {
      if (depth >= 3) ++result_.valid[depth - 3];
      extend(pose);
    }
    assignment_.pop_back();
    matched_.pop_back();
    used_[index] = false;
  }

  /// Three bearings with no gap of pi between them are seen from inside the triangle of their landmarks, which then has
  /// their order.
  [[nodiscard]] bool fitsOrder(int landmark) const
  {
    const double bearing = problem_.bearings[matched_.size()];
    const Vector2d& position = problem_.landmarks[static_cast<std::size_t>(landmark)];
    const double limit = kPi - 2 * problem_.options.max_residual;
    for (std::size_t i = 0; i < matched_.size(); ++i)
      for (std::size_t j = i + 1; j < matched_.size(); ++j)
      {
        const double to_j = wrap(matched_[j].bearing - matched_[i].bearing);
        const double to_new = wrap(bearing - matched_[j].bearing), back = wrap(matched_[i].bearing - bearing);
        const bool ccw = to_j > 0 && to_new > 0 && back > 0, cw = to_j < 0 && to_new < 0 && back < 0;
        if (!(ccw || cw) || std::max({std::abs(to_j), std::abs(to_new), std::abs(back)}) >= limit) continue;
        const double area = cross(matched_[j].landmark - matched_[i].landmark, position - matched_[i].landmark);
        if (ccw ? area <= 0 : area >= 0) return false;
      }
    return true;
  }

  bool count(std::uint64_t& counter)
  {
    ++counter;
    result_.finished = ++total_ <= problem_.options.max_tested;
    return result_.finished;
  }

  void record(const BearingPoseLinear& fit)
  {
    Interpretation found;
    found.assignment = assignment_;
    found.matched = static_cast<int>(assignment_.size());
    found.pose.mean = fit.pose;
    Matrix3d information = Matrix3d::Zero();
    const double sigma = problem_.stdBearing();
    const double per_match =
        std::log((1 - problem_.options.clutter_probability) / static_cast<double>(problem_.landmarks.size())) -
        0.5 * std::log(kTwoPi) - std::log(sigma);
    for (std::size_t i = 0; i < matched_.size(); ++i)
    {
      addInformation(information, bearingJacobian(fit.pose, matched_[i].landmark), sigma);
      found.max_residual = std::max(found.max_residual, std::abs(fit.residuals[i]));
      found.log_likelihood += per_match - 0.5 * square(fit.residuals[i] / sigma);
    }
    const std::optional<Matrix3d> covariance = covarianceFromInformation(information);
    if (covariance) found.pose.covariance = *covariance;
    result_.found.push_back(std::move(found));
  }

  const InterpretationProblem& problem_;
  bool in_order_;
  InterpretationCandidates result_;
  std::vector<bool> used_;
  std::vector<KnownBearing> matched_;
  std::vector<int> assignment_;
  std::uint64_t total_ = 0;
};
/// The interpretation tree of paper 000, section 3, to the letter, for comparison with interpretBearings(). Bearings in
/// the order given, all matched; depth 3: the pose by eq 1-6 exists (S not singular, r_1, r_2 > 0); deeper:
/// |predicted - measured| <= eps from the pose of the accepted prefix, then that pose is computed anew and must exist.
/// No area, no range limit, no unmatched bearings; three bearings at least.
/// It loses the true interpretation under noise (recall 0.4 to 0.7 at eps = 3.3 sigma), because the three-bearing pose
/// has its own error. The interpretations hold the closed-form pose with the covariance that a maximum-likelihood pose
/// there would have. `in_order`: children that contradict the circular order of the bearings are not compared at all
/// (the angular order of the paper; it loses nothing further).
inline Interpretations interpretByPaperRule(std::span<const Vector2d> landmarks,
                                            std::span<const AnonymousBearing> bearings,
                                            const InterpretationOptions& options, bool in_order = false)
{
  InterpretationProblem problem{landmarks, {}, {}, options};
  std::vector<int> all;
  for (int l = 0; l < static_cast<int>(landmarks.size()); ++l) all.push_back(l);
  for (const AnonymousBearing& b : bearings)
  {
    problem.bearings.push_back(wrap(b.bearing));
    problem.allowed.push_back(b.candidates.empty() ? all : b.candidates);
  }
  InterpretationCandidates search = PaperSearch(problem, in_order).run();
  Interpretations result;
  result.solutions = std::move(search.found);
  result.tested_by_depth = std::move(search.tested);
  result.valid_by_depth = std::move(search.valid);
  result.finished = search.finished;
  result.status = result.solutions.empty() ? SolveStatus::none : SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
