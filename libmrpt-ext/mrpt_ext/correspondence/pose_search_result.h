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
struct PoseSearchOptions
{
  double gate = 3.3;            ///< largest residual of a match [standard deviations]
  double keep_log_units = 12;   ///< poses less likely than the best by more than this are not returned
  std::size_t max_poses = 200;  ///< returned at most, the likeliest
  std::optional<Box2> area;     ///< where the robot can be; absent: anywhere
  /// Nodes after which an interpretation tree is given up, for each number of false bearings (see `finished`): a
  /// few bearings in a narrow view are consistent with thousands of poses.
  std::uint64_t max_tree_nodes = 200'000;
  /// Shared with other searches; a search also ends (see `finished`) after mostSearchWork() of its own
  /// (search_input.h).
  WorkBudget* budget = nullptr;
};

/// A pose that is consistent with the detections that `assignment` matches.
struct ConsistentPose
{
  GaussianPose pose;            ///< of the robot: maximum likelihood over the matches
  std::vector<int> assignment;  ///< landmark per detection, over all scans in order; -1: false detection
  int matched = 0;
  double log_likelihood = 0;  ///< of all detections at the pose; see pose_verification.h
  double log_evidence = 0;    ///< integrated over the uncertainty of the pose; poses are ranked by it
  double probability = 0;     ///< that this is the true pose
};

/// Result of a global pose search.
struct PoseSearchResult
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<ConsistentPose> poses;  ///< likeliest first; their probabilities leave room for `probability_elsewhere`
  double probability_elsewhere = 0;   ///< that none of the poses is the true one
  double expected_false = 0;          ///< wrong poses expected to have as many inliers as the best, by chance
  bool unique = false;                ///< one pose stands out (probability > 0.95) and expected_false <= 0.05
  bool finished = true;               ///< false: the search stopped at a limit, poses may be missing; none is unique

  struct Work
  {
    std::uint64_t tested = 0;    ///< constellations of landmarks compared with constellations of detections
    std::uint64_t verified = 0;  ///< candidate poses handed to verifyPose()
    int rounds = 0;              ///< constellations of detections tried
  } work;
};
}  // namespace mrpt_ext
