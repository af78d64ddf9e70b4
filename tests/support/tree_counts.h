#pragma once

#include "enumerated_interpretations.h"
#include "paper_interpretation_tree.h"

namespace mrpt_ext
{
/// N! / (N - K)!: ordered assignments of N landmarks to K bearings.
inline std::uint64_t totalPaths(int landmarks, int bearings)
{
  std::uint64_t paths = 1;
  for (int k = 0; k < bearings; ++k) paths *= static_cast<std::uint64_t>(landmarks - k);
  return paths;
}

/// Effort of an interpretation tree. Paper 000 does not define what its "examined" and "valid" paths are; here
/// a path is a child that was compared with its parent's pose.
struct TreeCounts
{
  double solved = 0;    ///< triples whose pose was asked for (depth 3)
  double triples = 0;   ///< those of them that are possible
  double examined = 0;  ///< children compared at depth 4 and deeper
  double valid = 0;     ///< those of them that passed
  std::set<std::vector<int>> assignments;
};

inline constexpr double kTreeGate = degToRad(0.5);

enum class TreeRule
{
  ours,
  paper,
  paper_in_order  ///< with angular order
};

/// Counts for exact or noisy bearings at this gate [rad]; our rule may also use that the robot is in the square.
inline TreeCounts countTree(const AnonymousScene& s, TreeRule rule, double gate = kTreeGate)
{
  InterpretationOptions options;
  options.max_residual = gate;
  if (rule == TreeRule::ours) options.area = Box2{{0, 0}, {10, 10}};
  const Interpretations result = rule == TreeRule::ours ? interpretBearings(s.scene.landmarks, s.bearings, options)
                                                        : interpretByPaperRule(s.scene.landmarks, s.bearings, options,
                                                                               rule == TreeRule::paper_in_order);
  TreeCounts counts;
  counts.assignments = assignmentsOf(result);
  for (std::size_t d = 0; d < result.tested_by_depth.size(); ++d)
  {
    (d == 0 ? counts.solved : counts.examined) += static_cast<double>(result.tested_by_depth[d]);
    (d == 0 ? counts.triples : counts.valid) += static_cast<double>(result.valid_by_depth[d]);
  }
  return counts;
}
}  // namespace mrpt_ext
