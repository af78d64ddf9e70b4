#pragma once

#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Larger maps and more bearings are for BearingSearch; see searchByTree.
inline constexpr std::size_t kLargestTreeMap = 40;
inline constexpr int kMostTreeBearings = 7;

/// Finds a lost robot with the interpretation tree (paper 000, section 3), for few landmarks and few bearings, where it
/// is complete and quickest: with four to six bearings no triple may be wasted, and the tree decides nearly singular
/// ones with a further bearing. The scan with most bearings is interpreted, first without false readings, then with
/// one more at a time until some pose explains the rest, and once more, because a pose that leaves one more reading
/// unexplained may yet fit better what was not seen. All scans judge the poses (pose_verification.h).
/// Status `too_few` below four bearings at one scan.
[[nodiscard]] PoseSearchResult searchByTree(const LandmarkIndex& map, std::span<const Scan> scans,
                                            const PoseSearchOptions& options);
}  // namespace mrpt_ext
