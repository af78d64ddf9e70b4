#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// Geometry of the landmarks in a frame, on which the accuracy of a pose depends.
struct FrameGeometry
{
  double time = 0;               ///< [s]
  std::size_t landmarks = 0;     ///< detections, those of one landmark by several sensors counted once
  std::optional<double> spread;  ///< [rad] smallest angle that holds all directions; absent below two of them
  std::optional<double> range;   ///< [m] median distance of the detected landmarks

  template <class Self, class Archive>
  static void archive(Self& g, Archive& fields)
  {
    fields(g.time, g.landmarks, g.spread, g.range);
  }
};

/// Nothing for a frame without a detection. A direction is the measured bearing, a distance the measured range; what
/// was not measured is taken from the map for detections with an id, where the true pose is known: the geometry
/// is used for evaluation only. `max_gap` [s]: of the truth, see interpolate().
[[nodiscard]] std::optional<FrameGeometry> frameGeometry(const Frame& frame, const LandmarkTable& map,
                                                         const Trajectory& truth, double max_gap);

/// Smallest angle [rad] that contains all `directions`; 0 for fewer than two.
[[nodiscard]] double angularSpread(std::vector<double> directions);
}  // namespace mrpt_ext
