#include "running_fix_trial.h"

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/heading_from_landmark.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext::papers
{
namespace
{
/// What both estimators and the bound know, as measurements of the second pose. The first range is one of a sensor that
/// sits where the robot was; the error of the way adds to it along the line of sight, alike in all directions.
std::vector<PoseMeasurement> asMeasurements(const FixMeasurement& m, bool with_bearing)
{
  using Kind = PoseMeasurement::Kind;
  const RunningFixReading& r = m.reading;
  const double way_std = std::sqrt(r.displacement_covariance(0, 0));
  const Pose2 first_in_second = inverse(r.displacement);
  std::vector<PoseMeasurement> all{{Kind::range, m.landmark, r.second_range, r.second_std, {}},
                                   {Kind::range,
                                    m.landmark,
                                    r.first_range,
                                    std::hypot(r.first_std, way_std),
                                    {first_in_second.x, first_in_second.y, 0}},
                                   {Kind::heading, {0, 0}, m.heading.heading, m.heading.std_heading, {}}};
  if (with_bearing) all.push_back({Kind::bearing, m.landmark, *r.second_bearing, r.second_bearing_std, {}});
  return all;
}
}  // namespace

FixMeasurement measureFix(const FixScene& scene, double first_range, double second_range, const FixNoise& noise,
                          RandomStream& random)
{
  FixMeasurement m;
  m.landmark = scene.landmark;
  RunningFixReading& r = m.reading;
  r.first_range = first_range;
  r.second_range = second_range;
  r.first_std = noise.first_range;
  r.second_std = noise.second_range;
  r.displacement = between(scene.first, scene.second);
  r.displacement.x += noise.displacement * random.gaussian();
  r.displacement.y += noise.displacement * random.gaussian();
  r.displacement_covariance = Vector3d(square(noise.displacement), square(noise.displacement), 0).asDiagonal();
  r.second_bearing = wrap(predictBearing(scene.second, scene.landmark) + noise.bearing * random.gaussian());
  r.second_bearing_std = noise.bearing;
  m.heading = {wrap(scene.second.phi + noise.heading * random.gaussian()), noise.heading};
  return m;
}

std::optional<RunningFixPose> closedFormFix(const FixMeasurement& measured)
{
  const RunningFixPoses poses = runningFixPoses(measured.reading, measured.landmark, measured.heading);
  if (poses.candidates.empty()) return std::nullopt;
  RunningFixPose best = poses.candidates.front();
  // Eq 7: the heading from the landmark as it is seen from the place found.
  const auto heading =
      headingFromBearing(measured.landmark, best.pose.mean.position(), *measured.reading.second_bearing);
  if (heading) best.pose.mean.phi = *heading;
  return best;
}

std::optional<GaussianPose> likeliestFix(const FixMeasurement& measured)
{
  // One range, bearing and heading already give a place: a start that needs no intersection.
  const double sight = measured.heading.heading + *measured.reading.second_bearing;
  const Vector2d start = measured.landmark - measured.reading.second_range * Vector2d(std::cos(sight), std::sin(sight));
  const PoseMl ml = refinePose(asMeasurements(measured, true), {start.x(), start.y(), measured.heading.heading});
  if (ml.status != SolveStatus::ok) return std::nullopt;
  return ml.pose;
}

std::optional<Matrix2d> fixBound(const FixScene& scene, const FixNoise& noise, bool with_bearing)
{
  RandomStream unused(0);
  FixNoise none = noise;
  none.displacement = none.heading = none.bearing = 0;
  FixMeasurement exact = measureFix(scene, predictRange(scene.first, scene.landmark),
                                    predictRange(scene.second, scene.landmark), none, unused);
  exact.reading.displacement_covariance =
      Vector3d(square(noise.displacement), square(noise.displacement), 0).asDiagonal();
  exact.heading.std_heading = noise.heading;
  exact.reading.second_bearing_std = noise.bearing;
  const auto covariance = covarianceFromInformation(poseInformation(asMeasurements(exact, with_bearing), scene.second));
  if (!covariance) return std::nullopt;
  return covariance->topLeftCorner<2, 2>();
}
}  // namespace mrpt_ext::papers
