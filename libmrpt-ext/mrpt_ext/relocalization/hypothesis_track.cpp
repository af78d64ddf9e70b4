#include "mrpt_ext/relocalization/hypothesis_track.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/correspondence/scan_matching.h"
#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
double clutterOf(const SensorModel& model) { return boundedClutter(model.clutter_probability); }

/// Log-density of clutter: its probability times the density of a false detection.
double logClutter(const LandmarkIndex& map, const AnonymousDetection& z, const SensorModel& model)
{
  return std::log(clutterOf(model) / map.measurementVolume(z, model));
}

/// Log-probability that a detection shows one given landmark of those in view.
double logPrior(const SensorModel& model, double in_view) { return std::log((1 - clutterOf(model)) / in_view); }

/// The innovation of a detection for one landmark.
struct Innovation
{
  Eigen::Vector2d residual = Eigen::Vector2d::Zero();  // an absent component has residual 0, row 0, variance 1
  Eigen::Matrix<double, 2, 3> rows = Eigen::Matrix<double, 2, 3>::Zero();
  Matrix2d variance = Matrix2d::Identity();
  double log_density = 0;
};

Innovation innovationOf(const GaussianPose& pose, const Scan& scan, const AnonymousDetection& z,
                        const Vector2d& landmark)
{
  Innovation innovation;
  const Vector2d offset = scan.T_robot_sensor.position();
  if (z.bearing)
  {
    innovation.residual(0) = wrap(*z.bearing - predictBearing(pose.mean, landmark, scan.T_robot_sensor));
    innovation.rows.row(0) = bearingJacobian(pose.mean, landmark, offset);
    innovation.variance(0, 0) = square(z.std_bearing);
  }
  if (z.range)
  {
    innovation.residual(1) = *z.range - predictRange(pose.mean, landmark, scan.T_robot_sensor);
    innovation.rows.row(1) = rangeJacobian(pose.mean, landmark, offset);
    innovation.variance(1, 1) = square(z.std_range);
  }
  innovation.variance += innovation.rows * pose.covariance * innovation.rows.transpose();
  const int values = (z.bearing ? 1 : 0) + (z.range ? 1 : 0);
  innovation.log_density = -0.5 * (innovation.residual.dot(innovation.variance.inverse() * innovation.residual) +
                                   std::log(innovation.variance.determinant()) + values * std::log(kTwoPi));
  return innovation;
}

void kalmanUpdate(GaussianPose& pose, const Innovation& innovation)
{
  const Eigen::Matrix<double, 3, 2> gain =
      pose.covariance * innovation.rows.transpose() * innovation.variance.inverse();
  const Vector3d step = gain * innovation.residual;
  pose.mean = {pose.mean.x + step.x(), pose.mean.y + step.y(), wrap(pose.mean.phi + step.z())};
  const Matrix3d covariance = pose.covariance - gain * innovation.variance * gain.transpose();
  pose.covariance = 0.5 * (covariance + covariance.transpose());
}
}  // namespace

void predict(HypothesisTrack& track, const TrajectoryStep& step)
{
  track.pose = compound(track.pose, step.increment, step.noise);
}

void retrodict(HypothesisTrack& track, const TrajectoryStep& step)
{
  GaussianPose& pose = track.pose;
  pose.mean = compose(pose.mean, inverse(step.increment));
  const Matrix3d J = composeJacobianFirst(pose.mean, step.increment), G = composeJacobianSecond(pose.mean);
  const Matrix3d back = J.inverse();
  pose.covariance = back * (pose.covariance + G * step.noise * G.transpose()) * back.transpose();
}

std::vector<int> update(HypothesisTrack& track, const LandmarkIndex& map, std::span<const Scan> scans, double gate)
{
  std::vector<int> landmarks;
  for (const Scan& scan : scans)
  {
    const std::vector<ExpectedLandmark> expected = expectedLandmarks(map, scan, track.pose);
    const auto in_view = std::count_if(expected.begin(), expected.end(), [](const auto& h) { return h.in_view; });
    const double log_prior = logPrior(scan.model, std::max(1.0, static_cast<double>(in_view)));
    const std::vector<int> matches = associate(map, scan, expected, gate);
    for (std::size_t d = 0; d < matches.size(); ++d)
    {
      const AnonymousDetection& z = scan.detections[d];
      const double log_clutter = logClutter(map, z, scan.model);
      landmarks.push_back(-1);
      if (matches[d] < 0)
      {
        track.log_evidence += log_clutter;
        continue;
      }
      const std::size_t landmark = expected[static_cast<std::size_t>(matches[d])].landmark;
      const Innovation innovation = innovationOf(track.pose, scan, z, map.position(landmark));
      const double log_landmark = log_prior + innovation.log_density;
      track.log_evidence += logSum(log_clutter, log_landmark);
      if (log_landmark < log_clutter) continue;
      kalmanUpdate(track.pose, innovation);
      landmarks.back() = static_cast<int>(landmark);
    }
  }
  return landmarks;
}

void updateAssociated(HypothesisTrack& track, const LandmarkIndex& map, std::span<const Scan> scans,
                      std::span<const int> landmarks)
{
  std::size_t d = 0;
  for (const Scan& scan : scans)
  {
    const std::vector<ExpectedLandmark> expected = expectedLandmarks(map, scan, {track.pose.mean, Matrix3d::Zero()});
    const auto in_view = std::count_if(expected.begin(), expected.end(), [](const auto& h) { return h.in_view; });
    const double log_prior = logPrior(scan.model, std::max(1.0, static_cast<double>(in_view)));
    for (const AnonymousDetection& z : scan.detections)
    {
      const int landmark = landmarks[d++];
      if (landmark < 0)
      {
        track.log_evidence += logClutter(map, z, scan.model);
        continue;
      }
      const Innovation innovation = innovationOf(track.pose, scan, z, map.position(static_cast<std::size_t>(landmark)));
      track.log_evidence += log_prior + innovation.log_density;
      kalmanUpdate(track.pose, innovation);
    }
  }
}

double expectedEvidence(const LandmarkIndex& map, std::span<const Scan> scans)
{
  double sum = 0;
  for (const Scan& scan : scans)
    for (const AnonymousDetection& z : scan.detections)
    {
      const double clutter = clutterOf(scan.model);
      double log_landmark = logPrior(scan.model, static_cast<double>(map.size()));
      if (z.bearing) log_landmark -= 0.5 + std::log(z.std_bearing * std::sqrt(kTwoPi));
      if (z.range) log_landmark -= 0.5 + std::log(z.std_range * std::sqrt(kTwoPi));
      sum += (1 - clutter) * log_landmark + clutter * logClutter(map, z, scan.model);
    }
  return sum;
}
}  // namespace mrpt_ext
