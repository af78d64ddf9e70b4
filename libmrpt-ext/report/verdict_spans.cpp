#include "mrpt_ext/report/verdict_spans.h"

#include <algorithm>

namespace mrpt_ext
{
std::vector<VerdictSpan> verdictSpans(const MethodTrack& track, Verdict verdict, double start, double resolution)
{
  std::vector<VerdictSpan> spans;
  const auto& points = track.points;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].verdict != verdict) continue;
    const double from = points[i].time - start;
    while (i + 1 < points.size() && points[i + 1].verdict == verdict) ++i;
    const double end = (i + 1 < points.size() ? points[i + 1].time : points[i].time) - start;
    if (!spans.empty() && from - spans.back().to < resolution)
      spans.back().to = end;
    else
      spans.push_back({from, std::max(end, from + resolution)});
  }
  return spans;
}
}  // namespace mrpt_ext
