#pragma once

#include <cstdint>
#include <vector>

#include "mrpt_ext/settings/settings.h"
#include "sample.h"

namespace mrpt_ext::papers
{
/// What a rule of the interpretation tree did over the maps.
struct TreeRuleCounts
{
  Sample examined;         ///< children compared with their parent's pose, depth 4 and deeper
  Sample solutions;        ///< complete assignments that were accepted
  double truth_found = 0;  ///< share of the maps
};

/// Twelve landmarks, so many bearings that nobody names (paper 000, table 1).
struct TreeResult
{
  int observations = 0;
  std::uint64_t total_paths = 0;
  TreeRuleCounts paper, ours;
  // Position errors [m] when all bearings are named, and what they would be at the Cramer-Rao bound.
  Sample closed_form_error, ml_error, bound_error;
};

struct TreeExperiment
{
  std::vector<TreeResult> results;                       ///< one per number of observations
  double two_then_one_paper = 0, two_then_one_ours = 0;  ///< share of the maps with 2, 1, 1 solutions at 5, 6, 7
};

[[nodiscard]] TreeExperiment runTreeExperiment(const Settings& settings);
}  // namespace mrpt_ext::papers
