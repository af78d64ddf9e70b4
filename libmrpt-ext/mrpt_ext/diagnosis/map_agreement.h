#pragma once

#include <string>

#include "mrpt_ext/diagnosis/landmark_check.h"
#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
/// Whether the filter ever agreed with the map. In a wrong map it finds poses that explain some of the detections by
/// chance, one after the other: they are `ambiguous` or `lost`, and never `ok`. Other causes of a run that is never
/// `ok` (symmetry, too few landmarks) leave the inlier ratio as it should be.
class MapAgreement
{
 public:
  /// The filter after a frame with detections; `inlier_ratio` of recent detections, relative to the expected one.
  void add(Verdict verdict, double inlier_ratio);
  /// True when no estimate was `ok`, and most had too low an inlier ratio for that.
  [[nodiscard]] bool neverAgreed() const;
  /// One line when the filter never agreed, or has seen one landmark alone; else empty. `frames` tells the cause where
  /// it kept some.
  [[nodiscard]] std::string hint(const LandmarkCheck& frames,
                                 const std::map<std::string, LandmarkRecord>& landmarks) const;

 private:
  std::size_t frames_ = 0, ok_ = 0, too_low_ = 0;
  double ratios_ = 0;  // sum
};
}  // namespace mrpt_ext
