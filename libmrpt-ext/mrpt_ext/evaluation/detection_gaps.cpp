#include "mrpt_ext/evaluation/detection_gaps.h"

#include <limits>

namespace mrpt_ext
{
ErrorsByDetections splitByDetections(const std::vector<ErrorSample>& errors, const RunContext& context)
{
  constexpr double kRounding = 1e-6;  // [s]
  ErrorsByDetections split;
  double last_detection = -std::numeric_limits<double>::infinity();
  auto frame = context.geometry.begin();
  for (const ErrorSample& error : errors)
  {
    for (; frame != context.geometry.end() && frame->time <= error.stamp + kRounding; ++frame)
      last_detection = frame->time;
    const bool blind = error.stamp - last_detection > kBlindAfter + kRounding;
    (blind ? split.blind : split.with_detections).push_back(error);
  }
  return split;
}
}  // namespace mrpt_ext
