#include <cstdio>
#include <vector>

#include "mrpt_ext/solvers/pose_ml.h"

// Feeds bearings one at a time and reads the estimate. The robot stands at (2, 1) and looks 30 degrees to the left of
// x.
int main()
{
  using namespace mrpt_ext;
  const std::vector<std::pair<Vector2d, double>> sightings{
      {{0, 0}, 176.565}, {{6, 0}, -44.036}, {{6, 5}, 15.0}, {{0, 5}, 86.565}};
  std::vector<PoseMeasurement> seen;
  Pose2 estimate{3, 2, 0};
  for (const auto& [landmark, bearing_deg] : sightings)
  {
    seen.push_back({.landmark = landmark, .value = degToRad(bearing_deg), .std = degToRad(0.5)});
    const PoseMl fit = refinePose(seen, estimate);
    if (fit.status == SolveStatus::ok) estimate = fit.pose.mean;
  }
  std::printf("estimate: %.2f %.2f %.1f\n", estimate.x, estimate.y, radToDeg(estimate.phi));
}
