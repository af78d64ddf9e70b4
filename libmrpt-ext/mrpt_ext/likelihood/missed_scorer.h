#pragma once

#include "mrpt_ext/likelihood/landmark_culling.h"
#include "mrpt_ext/likelihood/visibility_kernels.h"

namespace mrpt_ext
{
/// logMissedDetections() for all robots of a tile. Landmarks in view of none or of all robots of a block
/// count once per block; those at the rim are evaluated for each robot.
class MissedScorer
{
 public:
  MissedScorer(const Reading& reading, const LandmarkTable& map, const ScoringFrame& frame);

  /// What is summed for one block.
  struct Terms
  {
    std::vector<ViewedLandmark> rim;
    double log_sum = 0;             ///< of all others
    double mean = 0, variance = 0;  ///< likewise, of the count
  };

  void prepare(const LandmarkCulling& culling, Terms& terms) const;
  void addTo(const SensorTile& tile, const Terms& terms, SensorTile::Column& log_sum) const;

 private:
  const Reading& reading_;
  const LandmarkTable& map_;
  const ScoringFrame& frame_;
  VisibilityLimits limits_;
  bool identified_;
  std::vector<std::uint8_t> reported_;  // per landmark of the map
};
}  // namespace mrpt_ext
