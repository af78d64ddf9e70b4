#include "mrpt_ext/correspondence/local_map/landmark_track.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr double kNearest = 1;               // [m] landmarks closer than this to the trajectory are rare
constexpr std::size_t kEnoughToPredict = 8;  // detections, evenly chosen; all of them count in the end

WindowObservation observationOf(const PastScan& from, const AnonymousDetection& d, const Matrix3d& reference)
{
  return {
      from.scan.T_robot_sensor, from.odometry_covariance - reference, d.bearing, d.range, d.std_bearing, d.std_range};
}

TrackPrediction predictFromDirection(const PastScan& from, const PastScan& at, const AnonymousDetection& seen)
{
  const double inverse_depth = 0.25 / kNearest, std_inverse_depth = 0.25 / kNearest;
  const Vector2d ray = direction(from.scan.T_robot_sensor.phi + *seen.bearing);
  const Vector2d origin = from.scan.T_robot_sensor.position();
  TrackPrediction expected;
  expected.point.mean = origin + ray / inverse_depth;
  const Vector2d offset = expected.point.mean - at.scan.T_robot_sensor.position();
  // d point / d inverse depth = -ray / inverse_depth^2, seen across the line of sight.
  const double slope = cross(offset, ray) / (offset.squaredNorm() * square(inverse_depth));
  expected.bearing_variance = square(seen.std_bearing) + square(slope * std_inverse_depth);
  Eigen::Matrix<double, 2, 3> swing;
  swing << Matrix2d::Identity(), perpendicular(expected.point.mean);
  expected.point.covariance = swing * (from.odometry_covariance - at.odometry_covariance) * swing.transpose();
  return expected;
}

std::optional<GaussianPoint> predictedPoint(const LandmarkTrack& track, std::span<const PastScan> scans,
                                            const Matrix3d& reference)
{
  LandmarkTrack some = track;
  if (track.members.size() > kEnoughToPredict)
  {
    some.members.clear();
    for (std::size_t k = 0; k < kEnoughToPredict; ++k)  // the newest among them
      some.members.push_back(track.members[(k + 1) * track.members.size() / kEnoughToPredict - 1]);
  }
  const WindowLandmark found = locateLandmark(observationsOf(some, scans, reference));
  if (found.status != SolveStatus::ok || found.candidates.size() != 1) return std::nullopt;
  return found.candidates.front().in_robot;
}
}  // namespace

std::vector<WindowObservation> observationsOf(const LandmarkTrack& track, std::span<const PastScan> scans,
                                              const Matrix3d& reference_covariance)
{
  std::vector<WindowObservation> observations;
  for (const LandmarkTrack::Member& m : track.members)
    observations.push_back(
        observationOf(scans[m.scan], scans[m.scan].scan.detections[m.detection], reference_covariance));
  return observations;
}

TrackPrediction predictTrack(const LandmarkTrack& track, std::span<const PastScan> scans, std::size_t at)
{
  if (track.located)
    if (const auto point = predictedPoint(track, scans, scans[at].odometry_covariance)) return {*point, 0, true};
  const LandmarkTrack::Member& last = track.members.back();
  return predictFromDirection(scans[last.scan], scans[at], scans[last.scan].scan.detections[last.detection]);
}

TrackFit compare(const TrackPrediction& expected, const PastScan& at, const AnonymousDetection& d)
{
  const Vector2d offset = expected.point.mean - at.scan.T_robot_sensor.position();
  const double r = std::max(offset.norm(), 1e-6);
  Matrix2d H;  // bearing, range
  H.row(0) = perpendicular(offset).transpose() / (r * r);
  H.row(1) = offset.transpose() / r;
  Matrix2d S = H * expected.point.covariance * H.transpose();
  S(0, 0) += square(d.std_bearing) + expected.bearing_variance;
  const double turned = wrap(*d.bearing + at.scan.T_robot_sensor.phi - angleOf(offset));
  if (!d.range || !expected.depth_known) return {square(turned) / S(0, 0), 1};
  S(1, 1) += square(d.std_range);
  const Vector2d e(turned, *d.range - r);
  return {e.dot(S.inverse() * e), 2};
}

}  // namespace mrpt_ext
