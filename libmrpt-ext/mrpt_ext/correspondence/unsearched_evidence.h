#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/box.h"

namespace mrpt_ext
{
/// No landmark is detected for certain.
inline constexpr double kMaxDetectionProbability = 0.99;

/// Log of the evidence that all poses in `area` with fewer than `least` inliers are expected to have together, on
/// the scale of ConsistentPose::log_evidence: the likelihood of pose_verification.h integrated over position and
/// heading, with detections independent of one another, as they are at a wrong pose. Nothing is approximated by
/// modes, so poses that the matches do not determine (fewer than three bearings or two points) are included. For N
/// landmarks, each in view with probability q = pi R^2 / (area of the map) and then detected with probability P,
///   E_m = 2 pi |area| N! / (N - m)! (P q)^m (1 - P q)^(N - m) e_m,
/// e_m: sum over the choices of m detections, of the densities with which landmarks in view give these and clutter
/// gives the others. Without P: e_m alone, with the shares of true and false detections.
[[nodiscard]] double logEvidenceOfUnsearched(const LandmarkIndex& map, std::span<const Scan> scans, const Box2& area,
                                             int least);
/// The same for every `least` from 0 to one more than there are detections.
[[nodiscard]] std::vector<double> logEvidenceOfUnsearched(const LandmarkIndex& map, std::span<const Scan> scans,
                                                          const Box2& area);

/// Mean share of the map in view of a sensor somewhere in it, from range limit and field of view.
[[nodiscard]] double shareInView(const LandmarkIndex& map, const SensorModel& model);

/// Expected number of false detections of a scan. With a detection probability P: c / (1 - c) P n for n landmarks
/// in view on average, so that the declared share c of the detections is false on average; the number does not grow
/// with the landmarks in view this time. Without P: c times the number of detections.
[[nodiscard]] double expectedFalseDetections(const LandmarkIndex& map, const Scan& scan);

/// Where the robot can be: `area`, or else the extent of the map.
[[nodiscard]] Box2 areaOrMap(const LandmarkIndex& map, const std::optional<Box2>& area);
}  // namespace mrpt_ext
