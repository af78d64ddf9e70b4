#include "mrpt_ext/hypotheses/pose_hypothesis.h"

#include "mrpt_ext/geometry/mahalanobis.h"
#include "mrpt_ext/hypotheses/pruning.h"

namespace mrpt_ext
{
namespace
{
double logScore(const PoseHypothesis& hypothesis) { return hypothesis.log_score; }
}  // namespace

void rankByScore(HypothesisSet& hypotheses)
{
  if (hypotheses.empty()) return;
  sortByLogWeight(hypotheses, logScore);
  const double best = hypotheses.front().log_score;
  double sum = 0;
  for (PoseHypothesis& h : hypotheses) sum += h.weight = std::exp(h.log_score - best);
  for (PoseHypothesis& h : hypotheses) h.weight /= sum;
}

void mergeDuplicates(HypothesisSet& hypotheses, double distance, double angle)
{
  sortByLogWeight(hypotheses, logScore);
  mergeSame(hypotheses,
            [=](const PoseHypothesis& a, const PoseHypothesis& b)
            {
              const Vector3d apart = difference(a.pose.mean, b.pose.mean);
              if (!(apart.head<2>().norm() < distance) || a.heading_known != b.heading_known) return false;
              return !a.heading_known || std::abs(apart.z()) < angle;
            });
}
}  // namespace mrpt_ext
