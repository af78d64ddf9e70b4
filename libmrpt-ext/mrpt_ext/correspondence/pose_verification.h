#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Matches every detection to the landmark that explains it best within `options.gate` of what the pose, with its
/// covariance, predicts; refines the pose on the matches; repeats until the matches stay. Each landmark is matched at
/// most once per scan. Nothing when fewer than `least` detections can be matched, or the refined pose is degenerate or
/// outside the area.
///
/// log_likelihood of the result: with a detection probability P and n landmarks in scan (range limit, field of scan),
///   sum over scans of  n log(1 - P) + sum over detections log(clutter + P / (1 - P) sum_j N(z; h_j, R))
/// where clutter is the expected density of false detections (expectedFalseDetections() / V). Without P the detections
/// share the landmarks in scan: log(c / V + (1 - c) / n sum_j N). A landmark that is matched counts only for its match.
/// log_evidence adds log sqrt((2 pi)^3 det C), the Laplace approximation of the integral over the pose.
[[nodiscard]] std::optional<ConsistentPose> verifyPose(const LandmarkIndex& map, std::span<const Scan> scans,
                                                       const PoseSearchOptions& options, const GaussianPose& candidate,
                                                       int least);

/// Sorts by evidence, joins poses that are the same, drops those below `keep_log_units` or beyond `max_poses`, and sets
/// the probabilities, `probability_elsewhere`, `unique` and the status. `missed_evidence`: log of the evidence that all
/// poses with fewer than `complete_from` matches are expected to carry together (-infinity: none); those of them which
/// were found are a part of it. `expected_false` must be set before.
void rankPoses(PoseSearchResult& search, const PoseSearchOptions& options, double missed_evidence,
               int complete_from = 0);
}  // namespace mrpt_ext
