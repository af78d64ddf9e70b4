#include <Eigen/Cholesky>
#include <algorithm>

#include "mrpt_ext/correspondence/pose_verification.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSameRankedPose = 4;  // standard deviations below which two poses are one
constexpr double kStandsOut = 0.95;
constexpr double kMaxExpectedFalse = 0.05;

/// True when `b` lies within the uncertainty of `a`.
bool isSamePose(const ConsistentPose& a, const ConsistentPose& b)
{
  const Vector3d e(b.pose.mean.x - a.pose.mean.x, b.pose.mean.y - a.pose.mean.y,
                   wrap(b.pose.mean.phi - a.pose.mean.phi));
  // Cheap first: most poses are far apart.
  if (square(e.x()) > square(kSameRankedPose) * a.pose.covariance(0, 0)) return false;
  if (square(e.y()) > square(kSameRankedPose) * a.pose.covariance(1, 1)) return false;
  return e.dot(a.pose.covariance.ldlt().solve(e)) < square(kSameRankedPose);
}

std::vector<ConsistentPose> withoutRepeats(std::vector<ConsistentPose> sorted)
{
  std::vector<ConsistentPose> kept;
  for (ConsistentPose& pose : sorted)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const ConsistentPose& k) { return k.assignment == pose.assignment || isSamePose(k, pose); }))
      kept.push_back(std::move(pose));
  return kept;
}
}  // namespace

void rankPoses(PoseSearchResult& search, const PoseSearchOptions& options, double unsearched_evidence,
               int complete_from)
{
  std::stable_sort(search.poses.begin(), search.poses.end(),
                   [](const ConsistentPose& a, const ConsistentPose& b) { return a.log_evidence > b.log_evidence; });
  search.status = search.poses.empty() ? SolveStatus::none : SolveStatus::ok;
  search.probability_elsewhere = 1;
  search.unique = false;
  if (search.poses.empty()) return;

  double best_likelihood = search.poses.front().log_likelihood;
  for (const ConsistentPose& pose : search.poses) best_likelihood = std::max(best_likelihood, pose.log_likelihood);
  const double best = search.poses.front().log_evidence;
  std::erase_if(search.poses,
                [&](const ConsistentPose& pose)
                {
                  return pose.log_evidence < best &&  // the most evident one stays, whatever its likelihood
                         (pose.log_evidence < best - options.keep_log_units ||
                          pose.log_likelihood < best_likelihood - options.keep_log_units);
                });
  search.poses = withoutRepeats(std::move(search.poses));
  double total = 0, of_unsearched = 0, kept = 0;
  for (const ConsistentPose& pose : search.poses)
  {
    total += std::exp(pose.log_evidence - best);
    if (pose.matched < complete_from) of_unsearched += std::exp(pose.log_evidence - best);
  }
  total += std::max(0.0, std::exp(unsearched_evidence - best) - of_unsearched);
  if (search.poses.size() > options.max_poses) search.poses.resize(options.max_poses);
  for (ConsistentPose& pose : search.poses)
  {
    pose.probability = std::exp(pose.log_evidence - best) / total;
    kept += pose.probability;
  }
  search.probability_elsewhere = std::max(0.0, 1 - kept);
  search.unique = search.poses.front().probability > kStandsOut && search.expected_false <= kMaxExpectedFalse;
}
}  // namespace mrpt_ext
