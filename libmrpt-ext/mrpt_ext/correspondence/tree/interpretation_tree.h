#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/box.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A bearing to a landmark that the sensor could not name.
struct AnonymousBearing
{
  double bearing = 0;           ///< [rad, CCW from the sensor's forward axis]
  std::vector<int> candidates;  ///< landmark indices it may show (its category); empty: any
};

enum class InterpretationRule
{
  complete,       ///< finds every consistent interpretation; see interpretation_search.h
  paper,          ///< paper 000 to the letter: may lose the truth; see interpretation_paper.h
  paper_in_order  ///< the same, and landmarks around the robot must stand in the order of their bearings
};

/// How far a further bearing may lie from its prediction by the bearings matched so far. With s_i the sensitivity of
/// the prediction to each of them and eps = `max_residual`:
enum class InterpretationGate
{
  worst_case,  ///< eps (1 + sum |s_i|): no interpretation within eps is lost
  covariance   ///< k sqrt(sigma^2 + J P J^T) = eps sqrt(1 + sum s_i^2) for eps = k sigma: fewer nodes, k-sigma recall
};

struct InterpretationOptions
{
  InterpretationRule rule = InterpretationRule::complete;
  InterpretationGate gate = InterpretationGate::worst_case;
  double max_residual = 0.0175;         ///< eps [rad]: largest residual of a consistent interpretation, about 3.3 sigma
  std::optional<double> std_bearing;    ///< sigma [rad]; eps / 3.3 when absent
  int max_unmatched = 0;                ///< bearings that may show no landmark at all
  std::optional<Box2> area;             ///< where the sensor can be
  std::optional<double> max_range;      ///< of the sensor [m]
  double clutter_probability = 0.05;    ///< share of bearings that show no landmark, for the ranking
  bool allow_three = false;             ///< accept interpretations of three bearings, which nothing verifies
  std::uint64_t max_tested = 20000000;  ///< nodes after which the search gives up (see `finished`)
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
  bool finished = true;                        ///< false: `max_tested` stopped the search, more may exist
};

/// All poses from which the bearings can be explained (paper 000, section 3: interpretation tree). An interpretation is
/// consistent when its maximum-likelihood pose (equal weights) leaves no residual above eps and lies inside the area
/// and within range of its landmarks; landmarks that are not seen need no explanation. An interpretation that only
/// drops bearings from another consistent one is not listed. Where least squares creeps onto a landmark for ever, since
/// its bearing from there is whatever was measured, the pose beside it is taken (1e-4 of the way to the next one seen).
/// Poses are those of the sensor; for one at T_robot_sensor on the robot, compose with inverse(T_robot_sensor).
/// Status: `ok` with solutions, `none` without, `too_few` when less than four bearings can be matched (three with
/// allow_three), `bad_input` for non-finite numbers, eps <= 0, or a candidate that is no landmark index.
[[nodiscard]] Interpretations interpretBearings(std::span<const Vector2d> landmarks,
                                                std::span<const AnonymousBearing> bearings,
                                                const InterpretationOptions& options);
}  // namespace mrpt_ext
