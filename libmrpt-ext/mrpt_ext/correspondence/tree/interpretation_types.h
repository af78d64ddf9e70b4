#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/box.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
/// A bearing to a landmark of unknown identity.
struct AnonymousBearing
{
  double bearing = 0;           ///< [rad, CCW from the sensor's forward axis]
  std::vector<int> candidates;  ///< indices of the landmarks it may show (its category); empty: any
};

/// Largest residual of a further bearing against its prediction from the bearings matched so far. With s_i the
/// sensitivity of the prediction to each of them and eps = `max_residual`:
enum class InterpretationGate
{
  worst_case,  ///< eps (1 + sum |s_i|): no interpretation within eps is lost
  covariance   ///< k sqrt(sigma^2 + J P J^T) = eps sqrt(1 + sum s_i^2) for eps = k sigma: fewer nodes, k-sigma recall
};

struct InterpretationOptions
{
  InterpretationGate gate = InterpretationGate::worst_case;
  double max_residual = 0.0175;         ///< eps [rad]: largest residual of a consistent interpretation, about 3.3 sigma
  std::optional<double> std_bearing;    ///< sigma [rad]; eps / 3.3 when absent
  int max_unmatched = 0;                ///< false bearings that are allowed
  std::optional<Box2> area;             ///< where the sensor can be
  std::optional<double> max_range;      ///< of the sensor [m]
  double clutter_probability = 0.05;    ///< share of false bearings, for the ranking
  bool allow_three = false;             ///< accept interpretations of three bearings, which no further bearing verifies
  std::uint64_t max_tested = 20000000;  ///< nodes after which the search gives up (see `finished`)
  WorkBudget* budget = nullptr;         ///< ends it too; absent: unlimited
};

/// A consistent assignment of landmarks to bearings and its pose.
struct Interpretation
{
  std::vector<int> assignment;  ///< landmark index per bearing, -1: unmatched
  GaussianPose pose;            ///< of the sensor: maximum likelihood, covariance from sigma
  double max_residual = 0;      ///< [rad]
  double log_likelihood = 0;    ///< matched: (1 - c)/N N(residual; sigma); unmatched: c / 2 pi
  int matched = 0;
};

struct Interpretations
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<Interpretation> solutions;       ///< likeliest first
  std::vector<std::uint64_t> tested_by_depth;  ///< children compared at depth 3, 4, ... (number of matched bearings)
  std::vector<std::uint64_t> valid_by_depth;   ///< those that passed every check there
  bool finished = true;                        ///< false: a limit stopped the search, more may exist
};
}  // namespace mrpt_ext
