#include "mrpt_ext/hypotheses/pose_hypothesis.h"

#include <algorithm>

namespace mrpt_ext
{
void rankByScore(HypothesisSet& hypotheses)
{
  if (hypotheses.empty()) return;
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const PoseHypothesis& a, const PoseHypothesis& b) { return a.log_score > b.log_score; });
  const double best = hypotheses.front().log_score;
  double sum = 0;
  for (PoseHypothesis& h : hypotheses) sum += h.weight = std::exp(h.log_score - best);
  for (PoseHypothesis& h : hypotheses) h.weight /= sum;
}

void mergeDuplicates(HypothesisSet& hypotheses, double distance, double angle)
{
  HypothesisSet kept;
  for (PoseHypothesis& candidate : hypotheses)
  {
    const auto twin = std::find_if(
        kept.begin(), kept.end(),
        [&](const PoseHypothesis& other)
        {
          const bool same_place = (other.pose.mean.position() - candidate.pose.mean.position()).norm() < distance;
          const bool headings = other.heading_known && candidate.heading_known;
          const bool same_heading = headings ? std::abs(wrap(other.pose.mean.phi - candidate.pose.mean.phi)) < angle
                                             : other.heading_known == candidate.heading_known;
          return same_place && same_heading;
        });
    if (twin == kept.end())
      kept.push_back(std::move(candidate));
    else if (candidate.log_score > twin->log_score)
      *twin = std::move(candidate);
  }
  hypotheses = std::move(kept);
}
}  // namespace mrpt_ext
