#pragma once

#include <vector>

#include "drives.h"
#include "fix_study.h"
#include "located_experiment.h"
#include "movis_experiment.h"
#include "movis_yaw_scan.h"
#include "range_experiment.h"
#include "results_table.h"
#include "tree_experiment.h"

// From what was measured to what RESULTS.md says of it.
namespace mrpt_ext::papers
{
[[nodiscard]] ResultSection sectionTree(const TreeExperiment& tree);

/// Tables 1 to 4 of paper 001, and which cameras explain them.
[[nodiscard]] std::vector<ResultSection> sectionsMovis(const MovisExperiment& movis, const std::vector<YawTry>& scan,
                                                       const DriveErrors& drive, const DriveErrors& turned_drive);

/// What the rows of paper 001 tell of the measurements behind them, and what estimators make of these.
[[nodiscard]] std::vector<ResultSection> sectionsRebuilt(const MovisLattice& lattice);

/// Tables 1 to 4 of paper 004.
[[nodiscard]] ResultSection sectionRanges(const std::vector<RangeResult>& ranges,
                                          const std::vector<std::vector<RangeResult>>& other_places);
[[nodiscard]] std::vector<ResultSection> sectionsLocated(const LocatedExperiment& located, const DriveErrors& drive);
/// What it leaves open.
[[nodiscard]] ResultSection sectionFixStudy(const std::vector<FixStudyRow>& rows);

/// What is wrong in print, with what it does and the test that shows it.
[[nodiscard]] ResultSection sectionErrata();

/// Within two spreads of the print: reproduced; else it differs because of `reason`.
[[nodiscard]] Outcome withinTwoSpreads(const Sample& ours, double printed);
}  // namespace mrpt_ext::papers
