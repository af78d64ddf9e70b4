#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/box.h"

namespace mrpt_ext
{
/// Log of the evidence that all poses in `area` which explain fewer than `least` detections are expected to carry
/// together, on the scale of ConsistentPose::log_evidence: the likelihood of pose_verification.h, integrated over
/// position and heading, with the readings independent of one another as they are at a wrong pose. Nothing is
/// approximated by peaks, so that poses which the matches do not fix (fewer than three bearings or two points) are
/// counted too. For N landmarks, each in scan with probability q = pi R^2 / (area of the map) and then seen with
/// probability P,
///   E_m = 2 pi |area| N! / (N - m)! (P q)^m (1 - P q)^(N - m) e_m,
/// e_m: sum over the choices of m readings, of the densities at which landmarks in scan give these and clutter gives
/// the others. A sensor without P: e_m alone, with the shares of right and false detections.
[[nodiscard]] double logEvidenceOfUnsearched(const LandmarkIndex& map, std::span<const Scan> scans, const Box2& area,
                                             int least);
/// The same for every `least` from 0 to one more than there are detections.
[[nodiscard]] std::vector<double> logEvidenceOfUnsearched(const LandmarkIndex& map, std::span<const Scan> scans,
                                                          const Box2& area);

/// Share of the map's landmarks that a sensor has in scan from somewhere in it: by range limit and field of scan.
[[nodiscard]] double shareInView(const LandmarkIndex& map, const SensorModel& model);

/// Expected number of false detections of a scan. With a detection probability P it is what makes the declared share c
/// of the detections false on average, c / (1 - c) P n for n landmarks in scan on average, however many there are this
/// time: false ones do not become more when more landmarks are seen. Without P: c times the detections.
[[nodiscard]] double expectedFalseDetections(const LandmarkIndex& map, const Scan& scan);

/// Where the robot can be: `area`, or else the extent of the map.
[[nodiscard]] Box2 areaOrMap(const LandmarkIndex& map, const std::optional<Box2>& area);
}  // namespace mrpt_ext
