#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Associates every detection with the landmark of the smallest residual within `options.gate` of the prediction
/// (innovation gate with the covariance of the pose), refines the pose on the matches, and repeats until the
/// matches stay. Each landmark is matched at most once per scan. Nothing when fewer than `least` detections match,
/// or the refined pose is degenerate or outside the area.
///
/// log_likelihood of the result: with a detection probability P and n landmarks in view (range limit, field of
/// view),
///   sum over scans of  n log(1 - P) + sum over detections log(clutter + P / (1 - P) sum_j N(z; h_j, R))
/// where clutter is the expected density of false detections (expectedFalseDetections() / V). Without P the
/// detections share the landmarks in view: log(c / V + (1 - c) / n sum_j N). A matched landmark contributes only to
/// its match.
/// log_evidence adds log sqrt((2 pi)^3 det C), the Laplace approximation of the integral over the pose.
/// Spends what it does of `options.budget`, and finds nothing where that ends.
[[nodiscard]] std::optional<ConsistentPose> verifyPose(const LandmarkIndex& map, std::span<const Scan> scans,
                                                       const PoseSearchOptions& options, const GaussianPose& candidate,
                                                       int least);

/// Sorts by evidence, merges equal poses, drops those below `keep_log_units` or beyond `max_poses`, and sets the
/// probabilities, `probability_elsewhere`, `unique` and the status. `unsearched_evidence`: log of the evidence that
/// all poses with fewer than `complete_from` matches are expected to have together (-infinity: none); those of them
/// that were found are part of it. `expected_false` must be set before.
void rankPoses(PoseSearchResult& search, const PoseSearchOptions& options, double unsearched_evidence,
               int complete_from = 0);
}  // namespace mrpt_ext
