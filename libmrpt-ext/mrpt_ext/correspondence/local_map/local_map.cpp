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
constexpr int kPasses = 2;  // of finding tracks anew along the corrected way

/// The tracks' sightings, and where they put the landmarks and the way.
struct Settled
{
  BundleAdjustment adjusted;
  std::vector<LandmarkTrack::Member> members;  // of each sighting
  std::vector<std::size_t> tracks;             // likewise
};

Settled adjust(const std::vector<LandmarkTrack>& tracks, std::span<const PastScan> scans, bool robust)
{
  Settled result;
  std::vector<LandmarkObservation> sightings;
  std::vector<Vector2d> start;
  for (std::size_t j = 0; j < tracks.size(); ++j)
  {
    start.push_back(tracks[j].point.mean);
    for (const LandmarkTrack::Member& m : tracks[j].members)
    {
      const AnonymousDetection& d = scans[m.scan].scan.detections[m.detection];
      sightings.push_back({m.scan, j, d.bearing, d.range, d.std_bearing, d.std_range});
      result.members.push_back(m);
      result.tracks.push_back(j);
    }
  }
  std::vector<ScanPose> way;
  for (const PastScan& p : scans) way.push_back({p.scan.T_robot_sensor, p.odometry_covariance});
  result.adjusted = adjustBundle(way, sightings, std::move(start), robust);
  if (result.adjusted.status != SolveStatus::ok) result.adjusted.places = std::move(way);
  return result;
}

/// Takes the worst sighting from every track that has one beyond the gate; true if there was any. Tracks that have too
/// little left, or no point any more, go.
bool dropWorst(std::vector<LandmarkTrack>& tracks, const Settled& settled, std::span<const PastScan> scans,
               const LocalMapOptions& options)
{
  std::vector<double> worst(tracks.size(), 0);
  std::vector<LandmarkTrack::Member> member(tracks.size());
  for (std::size_t i = 0; i < settled.members.size(); ++i)
  {
    const std::size_t j = settled.tracks[i];
    if (settled.adjusted.misfits[i] <= worst[j]) continue;
    worst[j] = settled.adjusted.misfits[i];
    member[j] = settled.members[i];
  }
  bool any = false;
  for (std::size_t j = tracks.size(); j-- > 0;)
  {
    const auto& d = scans[member[j].scan].scan.detections[member[j].detection];
    if (worst[j] <= square(options.tracks.gate) * (d.range ? 2 : 1)) continue;
    any = true;
    std::erase_if(tracks[j].members, [&](const auto& m) { return m.scan == member[j].scan; });
    const bool enough = tracks[j].members.size() >= (d.range ? 1 : leastBearings(options.tracks, scans.size()));
    const auto found = enough ? locateLandmark(sightingsOf(tracks[j], scans, Matrix3d::Zero())) : WindowLandmark{};
    if (found.places.empty()) tracks.erase(tracks.begin() + static_cast<std::ptrdiff_t>(j));
  }
  return any;
}

/// Adjusts until every sighting agrees with the others, first robustly, so that the wrong ones are told from the right.
Settled settle(std::vector<LandmarkTrack>& tracks, std::span<const PastScan> scans, const LocalMapOptions& options)
{
  Settled settled;
  for (const bool robust : {true, false}) do
    {
      settled = adjust(tracks, scans, robust);
      while (settled.adjusted.status != SolveStatus::ok && !tracks.empty())
      {
        tracks.pop_back();  // found last: that with the least evidence
        settled = adjust(tracks, scans, robust);
      }
    } while (dropWorst(tracks, settled, scans, options));
  return settled;
}

/// The scans as the tracks themselves correct them; what remains unsure counts as each sighting's own deviation.
std::vector<PastScan> correctedBy(const std::vector<LandmarkTrack>& tracks, std::span<const PastScan> scans)
{
  std::vector<PastScan> corrected(scans.begin(), scans.end());
  const BundleAdjustment adjusted = adjust(tracks, scans, true).adjusted;
  if (adjusted.status != SolveStatus::ok) return corrected;
  for (std::size_t k = 0; k < scans.size(); ++k)
  {
    corrected[k].scan.T_robot_sensor = adjusted.places[k].T_robot_sensor;
    corrected[k].odometry_covariance.setZero();
    const Matrix3d& E = adjusted.places[k].odometry_covariance;
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

/// One sensor in the robot's centre that could have seen what any of them saw from anywhere on the way.
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

/// What no point stands for, at the corrected scans.
std::vector<PastScan> leftOver(std::span<const PastScan> scans, const std::vector<ScanPose>& corrected,
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

/// The detections of a scan that was left, with what odometry adds to each by itself.
Scan grown(const PastScan& carried)
{
  constexpr double kTypicalDistance = 3;  // [m] turns a shift into a turn where no range is measured
  Scan scan = carried.scan;
  const Matrix3d& E = carried.odometry_covariance;
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

LocalLandmarkMap buildLocalMap(std::span<const PastScan> oldest_first, const LocalMapOptions& options)
{
  LocalLandmarkMap result;
  if (oldest_first.size() < 2)
  {
    result.rest.assign(oldest_first.begin(), oldest_first.end());
    return result;
  }
  std::vector<LandmarkTrack> tracks = associateTracks(oldest_first, options.tracks);
  for (int pass = 0; pass < kPasses; ++pass)
    tracks = associateTracks(correctedBy(tracks, oldest_first), options.tracks);
  const Settled settled = settle(tracks, oldest_first, options);
  for (std::size_t j = 0; j < tracks.size(); ++j)
    if (isPrecise(settled.adjusted.landmarks[j], options.max_std))
      result.points.push_back({settled.adjusted.landmarks[j], tracks[j].category, std::move(tracks[j].members)});
  result.seen_by = commonModel(oldest_first);
  result.rest = leftOver(oldest_first, settled.adjusted.places, result.points);
  return result;
}

std::vector<Scan> asScans(const LocalLandmarkMap& joined)
{
  std::vector<Scan> scans;
  Scan points{{}, joined.seen_by, {}};
  for (const LocalLandmark& point : joined.points)
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
  for (const PastScan& carried : joined.rest) scans.push_back(grown(carried));
  return scans;
}
}  // namespace mrpt_ext
