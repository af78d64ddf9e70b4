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

/// Global localization with the interpretation tree (paper 000, section 3), for few landmarks and few bearings,
/// where it is complete and fastest: with four to six bearings no triple may be wasted, and the tree decides nearly
/// singular ones with a further bearing. The scan with most bearings is interpreted, first without false bearings,
/// then with one more at a time until some pose matches the rest, and once more, because a pose with one outlier
/// more may fit the missed detections better. All scans take part in the verification (pose_verification.h).
/// Status `too_few` below four bearings in one scan.
[[nodiscard]] PoseSearchResult searchByTree(const LandmarkIndex& map, std::span<const Scan> scans,
                                            const PoseSearchOptions& options);
}  // namespace mrpt_ext
