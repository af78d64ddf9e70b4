#include "mrpt_ext/report/verdict_spans.h"

#include <algorithm>

namespace mrpt_ext
{
std::vector<VerdictSpan> verdictSpans(const MethodTrajectory& trajectory, Verdict verdict, double start,
                                      double resolution)
{
  std::vector<VerdictSpan> spans;
  const auto last = trajectory.points.end();
  for (auto point = trajectory.points.begin(); point != last; ++point)
  {
    if (point->verdict != verdict) continue;
    const double from = point->time - start;
    double end = from;
    for (; point != last && point->verdict == verdict; ++point) end = point->time - start;
    if (point != last) end = point->time - start;
    if (!spans.empty() && from - spans.back().to < resolution)
      spans.back().to = end;
    else
      spans.push_back({from, std::max(end, from + resolution)});
    if (point == last) break;
  }
  return spans;
}
}  // namespace mrpt_ext
