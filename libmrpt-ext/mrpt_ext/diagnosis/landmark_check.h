#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// Why most landmarks seem wrong.
enum class LandmarkFault
{
  motion,    ///< single frames fit the map, their sequence does not fit the motion
  mirrored,  ///< frames fit with bearings counted the other way round
  radians,   ///< frames fit with bearings that were given in radians
  unit,      ///< frames fit a map in another unit
  unknown    ///< frames do not fit the map in any of these ways
};

struct LandmarkFaultFinding
{
  LandmarkFault fault = LandmarkFault::unknown;
  double factor = 1;  ///< that the map must be multiplied by, for `unit`
};

/// Keeps some frames of a run with identified detections. If most landmarks are often wrong, it is not the landmarks:
/// the pose of each frame alone then tells whether it is the map, the signs, the unit or the motion.
class LandmarkCheck
{
 public:
  /// `map` must outlive it.
  explicit LandmarkCheck(const LandmarkTable& map) : map_(map) {}

  void add(const Frame& frame);
  [[nodiscard]] LandmarkFaultFinding findFault() const;
  /// What to check when most detections disagree with the map, in words; also where no frame tells it.
  [[nodiscard]] std::string cause() const;
  /// One line when most of the landmarks that were seen are often wrong; else empty.
  [[nodiscard]] std::string hint(const std::map<std::string, LandmarkRecord>& landmarks) const;

 private:
  using Measurements = std::vector<PoseMeasurement>;
  /// Share of the frames that a pose explains, after `change`.
  template <typename Change>
  [[nodiscard]] double explained(const Change& change) const;

  const LandmarkTable& map_;
  std::vector<Measurements> frames_;
  std::size_t offered_ = 0, stride_ = 1;
};
}  // namespace mrpt_ext
