#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "mrpt_ext/correspondence/tree/interpretation_tree.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "random_scene.h"

namespace mrpt_ext
{
/// Anonymous bearings of a random scene.
struct AnonymousScene
{
  Scene scene;
  std::vector<AnonymousBearing> bearings;
  std::vector<int> truth;  ///< landmark per bearing; -1: false bearing
};

/// `seen` of the landmarks in random order, with Gaussian noise [rad], then false bearings in random directions.
inline AnonymousScene observeAnonymously(RandomStream& random, int landmark_count, int seen, int false_count,
                                         double noise)
{
  AnonymousScene s;
  s.scene = randomScene(random, landmark_count);
  std::vector<int> rest;
  for (int i = 0; i < landmark_count; ++i) rest.push_back(i);
  for (int k = 0; k < seen; ++k)
  {
    const auto pick = rest.begin() + static_cast<long>(random.below(rest.size()));
    const double b = predictBearing(s.scene.robot, s.scene.landmarks[static_cast<std::size_t>(*pick)]);
    s.bearings.push_back({wrap(b + noise * random.gaussian()), {}});
    s.truth.push_back(*pick);
    rest.erase(pick);
  }
  for (int k = 0; k < false_count; ++k)
  {
    const auto at = static_cast<long>(random.below(s.bearings.size() + 1));
    s.bearings.insert(s.bearings.begin() + at, {random.uniform(-kPi, kPi), {}});
    s.truth.insert(s.truth.begin() + at, -1);
  }
  return s;
}

/// True if the search found an interpretation that associates every detected landmark.
inline bool findsTruth(const Interpretations& result, const std::vector<int>& truth)
{
  return std::any_of(result.solutions.begin(), result.solutions.end(),
                     [&](const Interpretation& found)
                     {
                       for (std::size_t i = 0; i < truth.size(); ++i)
                         if (truth[i] >= 0 && found.assignment[i] != truth[i]) return false;
                       return true;
                     });
}

inline std::set<std::vector<int>> assignmentsOf(const Interpretations& result)
{
  std::set<std::vector<int>> all;
  for (const Interpretation& s : result.solutions) all.insert(s.assignment);
  return all;
}

/// The definition of a consistent interpretation, by trying every ordered assignment of all bearings. Each is refined
/// from the closed form and from a grid of starts, and its best pose verified.
class InterpretationEnumeration
{
 public:
  InterpretationEnumeration(const AnonymousScene& scene, const InterpretationOptions& options, int starts_per_side)
      : scene_(scene), options_(options), starts_per_side_(starts_per_side)
  {
    extend();
  }

  std::set<std::vector<int>> found;
  bool doubtful = false;  ///< some assignment is between 0.9 and 1.25 gates, or at the border of the area

 private:
  void extend()
  {
    if (assignment_.size() == scene_.bearings.size()) return judge();
    for (int l = 0; l < static_cast<int>(scene_.scene.landmarks.size()); ++l)
    {
      if (std::find(assignment_.begin(), assignment_.end(), l) != assignment_.end()) continue;
      assignment_.push_back(l);
      extend();
      assignment_.pop_back();
    }
  }

  void judge()
  {
    const PoseMl best = bestPose();
    if (best.status != SolveStatus::ok) return;
    double gates = 0;
    for (const double r : best.residuals) gates = std::max(gates, std::abs(r) / options_.max_residual);
    const Vector2d p = best.pose.mean.position();
    const Box2& area = *options_.area;
    const double inside = std::min((p - area.min).minCoeff(), (area.max - p).minCoeff());
    if (inside > -1e-3 && gates < 1.25 && (gates > 0.9 || inside < 1e-3)) doubtful = true;
    if (inside > 0 && gates <= 1) found.insert(assignment_);
  }

  [[nodiscard]] PoseMl bestPose() const
  {
    std::vector<KnownBearing> known;
    std::vector<PoseMeasurement> measurements;
    for (std::size_t i = 0; i < assignment_.size(); ++i)
    {
      const Vector2d& landmark = scene_.scene.landmarks[static_cast<std::size_t>(assignment_[i])];
      known.push_back({landmark, scene_.bearings[i].bearing, 1});
      measurements.push_back({PoseMeasurement::Kind::bearing, landmark, scene_.bearings[i].bearing, 1, {}});
    }
    PoseMl best = solveBearingPoseMl(known);
    const double within_gates = static_cast<double>(known.size()) * square(options_.max_residual);
    if (best.status == SolveStatus::ok && best.chi2 < within_gates) return best;
    const Vector2d cell = (options_.area->max - options_.area->min) / starts_per_side_;
    for (int i = 0; i < starts_per_side_; ++i)
      for (int j = 0; j < starts_per_side_; ++j)
      {
        const Vector2d start = options_.area->min + Vector2d((i + 0.5) * cell.x(), (j + 0.5) * cell.y());
        PoseMl fit = refinePose(measurements, {start.x(), start.y(), meanHeading(known, start)});
        const bool better = best.status != SolveStatus::ok || fit.chi2 < best.chi2;
        if (fit.status == SolveStatus::ok && better) best = std::move(fit);
      }
    return best;
  }

  const AnonymousScene& scene_;
  const InterpretationOptions& options_;
  int starts_per_side_;
  std::vector<int> assignment_;
};
}  // namespace mrpt_ext
