#include "mrpt_ext/experiment/frame_bounds.h"

#include <cmath>

#include "mrpt_ext/evaluation/error_statistics.h"
#include "mrpt_ext/evaluation/information_bound.h"
#include "mrpt_ext/evaluation/scoring.h"
#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
std::optional<FrameBound> boundOfFrames(const FrameStream& frames, const LandmarkTable& map, const Trajectory& truth,
                                        BoundOf what)
{
  std::vector<double> position, heading;
  while (const auto frame = frames())
  {
    const auto pose = interpolate(truth, frame->time, kMaxTruthGap);
    if (!pose) continue;
    std::vector<LandmarkMeasurement> seen = identifiedMeasurements(frame->readings, map);
    if (what == BoundOf::bearings)
      for (LandmarkMeasurement& s : seen) s.range.reset(), s.headings.reset();
    const auto bound = informationBound(poseInformation(poseMeasurements(seen), pose->pose));
    if (!bound) continue;
    position.push_back(bound->position_rms);
    heading.push_back(radToDeg(std::sqrt(bound->covariance(2, 2))));
  }
  if (position.empty()) return std::nullopt;
  const ErrorStatistics of_position = errorStatistics(position), of_heading = errorStatistics(heading);
  return FrameBound{position.size(), *of_position.rmse, *of_position.median, *of_heading.rmse};
}
}  // namespace mrpt_ext
