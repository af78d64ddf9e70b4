#pragma once

#include <vector>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/range_scan.h"

namespace mrpt_ext
{
enum class ReflectorShape
{
  round,  ///< a post: its centre lies half a diameter behind what is seen
  flat    ///< a plate that faces the scanner
};

/// What sends beams back strongly.
struct ReflectorOptions
{
  double intensity_above = 0;  ///< of every beam on a reflector, in units of the scanner
  double diameter = 0;         ///< [m] of the post, width of the plate; 0: not known, centres lie on the surface
  ReflectorShape shape = ReflectorShape::round;
};

/// The reflectors in a scan: detections without names, by bearing and range of the centre.
struct Reflectors
{
  std::vector<Detection> detections;
  std::size_t too_wide = 0;  ///< bright surfaces that are wider than a reflector of this diameter can appear
};

/// Neighbouring bright beams at one distance are one reflector; one dark beam between them is let pass. Its bearing is
/// the middle between the outermost beams. Either edge lies anywhere between two beams, so the standard deviation is
/// spacing / sqrt(24); with a single beam spacing / sqrt(12). The range to the centre is the median of what the beams
/// say, each by the circle (or the plane) that it meets; errors of neighbouring beams on one surface are alike, so that
/// the standard deviation remains that of one range.
[[nodiscard]] Reflectors extractReflectors(const RangeScan& scan, const ReflectorOptions& options);

/// The reflectors as a reading, whose ranges are horizontal. It states the field of view where the scan is symmetric
/// about the forward axis.
[[nodiscard]] Reading reflectorReading(const RangeScan& scan, Reflectors reflectors);
}  // namespace mrpt_ext
