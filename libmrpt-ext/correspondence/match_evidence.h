#pragma once

#include <cmath>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/sensor_place.h"

namespace mrpt_ext
{
/// What one more matched bearing typically adds to the log-likelihood of a pose (pose_judge.h): it is explained, and
/// not by chance. `std_bearing` [rad]; `in_view`: landmarks that it may show.
[[nodiscard]] double logEvidencePerBearing(const SensorPlace& place, double std_bearing, double in_view);

/// The same for a bearing with a range.
[[nodiscard]] double logEvidencePerPoint(const SensorPlace& place, const LandmarkIndex& map);

/// Evidence, relative to that of a pose with `best` matches, that wrong poses with fewer than `least` matches, but at
/// least `fewest`, are expected to carry together. `expected(m)`: expected number of wrong poses with m or more.
template <typename Expected>
[[nodiscard]] double evidenceBelow(int least, int best, int fewest, double log_evidence_per_match, Expected&& expected)
{
  double evidence = 0;
  for (int m = least - 1; m >= fewest; --m)
    evidence += (expected(m) - expected(m + 1)) * std::exp(-log_evidence_per_match * (best - m));
  return evidence;
}
}  // namespace mrpt_ext
