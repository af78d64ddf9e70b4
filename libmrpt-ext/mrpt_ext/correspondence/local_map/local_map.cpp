#include "mrpt_ext/correspondence/local_map/local_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/solvers/local_bundle_adjustment.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr int kPasses = 2;       // of associating again along the corrected trajectory
constexpr double kMaxStd = 0.3;  // [m] a point less certain than this in any direction is left as bearings

/// The observations of all tracks, and the adjusted landmarks and trajectory.
struct AdjustedTracks
{
  BundleAdjustment adjusted;
  std::vector<LandmarkTrack::Member> members;  // of each detection
  std::vector<std::size_t> tracks;             // likewise
};

/// Operations of one adjustment: the landmarks eliminated from the normal equations of the trajectory.
std::uint64_t costOfAdjustment(std::size_t tracks, std::size_t scans)
{
  constexpr std::uint64_t kOfTheWhole = 10, kOfASighting = 2000;  // of iterations with vector instructions
  const std::uint64_t unknowns = 3 * scans;
  return kOfTheWhole * unknowns * unknowns * (tracks + unknowns) + kOfASighting * tracks * scans;
}

AdjustedTracks adjust(const std::vector<LandmarkTrack>& tracks, std::span<const PastScan> scans, bool robust)
{
  AdjustedTracks result;
  std::vector<LandmarkObservation> observations;
  std::vector<Vector2d> start;
  for (std::size_t j = 0; j < tracks.size(); ++j)
  {
    start.push_back(tracks[j].point.mean);
    for (const LandmarkTrack::Member& m : tracks[j].members)
    {
      const AnonymousDetection& d = scans[m.scan].scan.detections[m.detection];
      observations.push_back({m.scan, j, d.bearing, d.range, d.std_bearing, d.std_range});
      result.members.push_back(m);
      result.tracks.push_back(j);
    }
  }
  std::vector<ScanPose> scan_poses;
  for (const PastScan& p : scans) scan_poses.push_back({p.scan.T_robot_sensor, p.odometry_covariance});
  result.adjusted = adjustBundle(scan_poses, observations, std::move(start), robust);
  if (result.adjusted.status != SolveStatus::ok) result.adjusted.poses = std::move(scan_poses);
  return result;
}

/// Removes the worst detection from every track that has one beyond the gate; true if there was any. Tracks with
/// too few detections left, or no point any more, are dropped.
bool dropWorst(std::vector<LandmarkTrack>& tracks, const AdjustedTracks& adjusted_tracks,
               std::span<const PastScan> scans)
{
  std::vector<double> worst(tracks.size(), 0);
  std::vector<LandmarkTrack::Member> member(tracks.size());
  for (std::size_t i = 0; i < adjusted_tracks.members.size(); ++i)
  {
    const std::size_t j = adjusted_tracks.tracks[i];
    if (adjusted_tracks.adjusted.misfits[i] <= worst[j]) continue;
    worst[j] = adjusted_tracks.adjusted.misfits[i];
    member[j] = adjusted_tracks.members[i];
  }
  bool any = false;
  for (std::size_t j = tracks.size(); j-- > 0;)
  {
    const auto& d = scans[member[j].scan].scan.detections[member[j].detection];
    if (worst[j] <= square(kTrackGate) * (d.range ? 2 : 1)) continue;
    any = true;
    std::erase_if(tracks[j].members, [&](const auto& m) { return m.scan == member[j].scan; });
    const bool enough = tracks[j].members.size() >= (d.range ? 1 : leastBearings(scans.size()));
    const auto found = enough ? locateLandmark(observationsOf(tracks[j], scans, Matrix3d::Zero())) : WindowLandmark{};
    if (found.candidates.empty()) tracks.erase(tracks.begin() + static_cast<std::ptrdiff_t>(j));
  }
  return any;
}

/// Adjusts until every detection is within the gate, first robustly, so that wrong associations stand out. No tracks
/// are left where the budget ends before.
AdjustedTracks adjustUntilConsistent(std::vector<LandmarkTrack>& tracks, std::span<const PastScan> scans,
                                     WorkBudget& budget)
{
  AdjustedTracks adjusted_tracks;
  for (const bool robust : {true, false}) do
    {
      if (!budget.spend(costOfAdjustment(tracks.size(), scans.size()))) tracks.clear();
      adjusted_tracks = adjust(tracks, scans, robust);
      while (adjusted_tracks.adjusted.status != SolveStatus::ok && !tracks.empty())
      {
        if (budget.spend(costOfAdjustment(tracks.size(), scans.size())))
          tracks.pop_back();  // found last: the one with the least evidence
        else
          tracks.clear();
        adjusted_tracks = adjust(tracks, scans, robust);
      }
    } while (dropWorst(tracks, adjusted_tracks, scans));
  return adjusted_tracks;
}

/// The scans at the poses that the tracks imply; the remaining uncertainty is added to the standard deviations.
std::vector<PastScan> correctedScans(const std::vector<LandmarkTrack>& tracks, std::span<const PastScan> scans)
{
  std::vector<PastScan> corrected(scans.begin(), scans.end());
  const BundleAdjustment adjusted = adjust(tracks, scans, true).adjusted;
  if (adjusted.status != SolveStatus::ok) return corrected;
  for (std::size_t k = 0; k < scans.size(); ++k)
  {
    corrected[k].scan.T_robot_sensor = adjusted.poses[k].T_robot_sensor;
    corrected[k].odometry_covariance.setZero();
    const Matrix3d& E = adjusted.poses[k].odometry_covariance;
    for (AnonymousDetection& d : corrected[k].scan.detections)
    {
      d.std_bearing = std::sqrt(square(d.std_bearing) + E(2, 2));
      d.std_range = std::sqrt(square(d.std_range) + 0.5 * E.topLeftCorner<2, 2>().trace());
    }
  }
  return corrected;
}

bool isPrecise(const GaussianPoint& point, double max_std)
{
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(point.covariance, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().y() <= square(max_std);
}

/// Model of one sensor at the robot's centre with everything in view that was in view along the trajectory.
SensorModel commonModel(std::span<const PastScan> scans)
{
  SensorModel model;
  model.clutter_probability = 0;
  double reach = 0;
  for (const PastScan& p : scans)
  {
    model.clutter_probability = std::max(model.clutter_probability, p.scan.model.clutter_probability);
    const double limit = p.scan.model.max_range.value_or(std::numeric_limits<double>::infinity());
    reach = std::max(reach, limit + p.scan.T_robot_sensor.position().norm());
  }
  if (std::isfinite(reach)) model.max_range = reach;
  return model;
}

/// The detections outside every point, at the corrected poses.
std::vector<PastScan> unmatchedDetections(std::span<const PastScan> scans, const std::vector<ScanPose>& corrected,
                                          const std::vector<LocalLandmark>& points)
{
  std::vector<std::vector<bool>> used;
  for (const PastScan& p : scans) used.emplace_back(p.scan.detections.size(), false);
  for (const LocalLandmark& point : points)
    for (const LandmarkTrack::Member& m : point.members) used[m.scan][m.detection] = true;
  std::vector<PastScan> rest;
  for (std::size_t k = 0; k < scans.size(); ++k)
  {
    PastScan left = scans[k];
    left.scan.T_robot_sensor = corrected[k].T_robot_sensor;
    left.odometry_covariance = corrected[k].odometry_covariance;
    left.scan.detections.clear();
    for (std::size_t d = 0; d < used[k].size(); ++d)
      if (!used[k][d]) left.scan.detections.push_back(scans[k].scan.detections[d]);
    if (!left.scan.detections.empty()) rest.push_back(std::move(left));
  }
  return rest;
}

/// A past scan whose standard deviations include the error of odometry, as if independent.
Scan withOdometryNoise(const PastScan& past)
{
  constexpr double kTypicalDistance = 3;  // [m] converts a shift into an angle where no range is measured
  Scan scan = past.scan;
  const Matrix3d& E = past.odometry_covariance;
  if (E.isZero(0)) return scan;
  scan.model.detection_probability.reset();
  Eigen::Matrix<double, 2, 3> swing;
  swing << Matrix2d::Identity(), perpendicular(scan.T_robot_sensor.position());
  const double shift = (swing * E * swing.transpose()).diagonal().maxCoeff();
  for (AnonymousDetection& d : scan.detections)
  {
    const double distance = d.range.value_or(kTypicalDistance);
    d.std_bearing = std::sqrt(square(d.std_bearing) + E(2, 2) + shift / square(distance));
    d.std_range = std::sqrt(square(d.std_range) + shift);
  }
  return scan;
}
}  // namespace

LocalLandmarkMap buildLocalMap(std::span<const PastScan> oldest_first, WorkBudget& budget)
{
  LocalLandmarkMap result;
  if (oldest_first.size() < 2)
  {
    result.rest.assign(oldest_first.begin(), oldest_first.end());
    return result;
  }
  std::vector<LandmarkTrack> tracks = associateTracks(oldest_first, budget);
  for (int pass = 0; pass < kPasses && budget.spend(costOfAdjustment(tracks.size(), oldest_first.size())); ++pass)
    tracks = associateTracks(correctedScans(tracks, oldest_first), budget);
  const AdjustedTracks adjusted_tracks = adjustUntilConsistent(tracks, oldest_first, budget);
  for (std::size_t j = 0; j < tracks.size(); ++j)
    if (isPrecise(adjusted_tracks.adjusted.landmarks[j], kMaxStd))
      result.points.push_back(
          {adjusted_tracks.adjusted.landmarks[j], tracks[j].category, std::move(tracks[j].members)});
  result.sensor = commonModel(oldest_first);
  result.rest = unmatchedDetections(oldest_first, adjusted_tracks.adjusted.poses, result.points);
  return result;
}

std::vector<Scan> asScans(const LocalLandmarkMap& local_map)
{
  std::vector<Scan> scans;
  Scan points{{}, local_map.sensor, {}};
  for (const LocalLandmark& point : local_map.points)
  {
    const Vector2d& v = point.in_robot.mean;
    const double distance = std::max(v.norm(), 1e-6);
    const Vector2d along = v / distance, across = perpendicular(along);
    const Matrix2d& C = point.in_robot.covariance;
    points.detections.push_back({.bearing = angleOf(v),
                                 .range = distance,
                                 .std_bearing = std::sqrt(across.dot(C * across)) / distance,
                                 .std_range = std::sqrt(along.dot(C * along)),
                                 .category = point.category});
  }
  if (!points.detections.empty()) scans.push_back(std::move(points));
  for (const PastScan& past : local_map.rest) scans.push_back(withOdometryNoise(past));
  return scans;
}
}  // namespace mrpt_ext
