#include "mrpt_ext/filter/integrity/point_null_model.h"

#include <Eigen/LU>
#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxPoints = 100;  // those not seen for longest are dropped

double normalDensity(const Vector2d& residual, const Matrix2d& covariance)
{
  return std::exp(-0.5 * residual.dot(covariance.inverse() * residual)) /
         (kTwoPi * std::sqrt(covariance.determinant()));
}

bool isInView(const Vector2d& point, const Reading& reading)
{
  const Vector2d ray = transform(inverse(reading.T_robot_sensor), point);
  return std::abs(std::atan2(ray.y(), ray.x())) <= reading.model.field_of_view / 2 &&
         ray.norm() <= reading.model.max_range.value_or(ray.norm());
}
}  // namespace

void PointNullModel::move(const OdometryMotion& motion)
{
  const Pose2 step = nominalMotion(motion_, motion).increment;
  const Matrix3d noise = incrementCovariance(motion_, motion);
  const Matrix2d back = rotation(step.phi).transpose();
  for (TrackedPoint& feature : features_)
  {
    feature.mean = transform(inverse(step), feature.mean);
    Eigen::Matrix<double, 2, 3> by_step;
    by_step << -back, Vector2d(feature.mean.y(), -feature.mean.x());
    feature.covariance = back * feature.covariance * back.transpose() + by_step * noise * by_step.transpose();
  }
}

FeatureMixture::Outcome PointNullModel::observe(const Reading& reading, const Detection& detection)
{
  const double range = *detection.range, bearing = *detection.bearing;
  const Vector2d ray(std::cos(bearing), std::sin(bearing));
  TrackedPoint seen{reading.sensor, detection.category, transform(reading.T_robot_sensor, range * ray), {}};
  const Matrix2d axes = rotation(reading.T_robot_sensor.phi + bearing);
  seen.covariance = axes * Vector2d(square(detection.std_range), square(range * detection.std_bearing)).asDiagonal() *
                    axes.transpose();

  const double uniform = 1 / measurementVolume(detection, reading.model, max_range_);
  FeatureDensities known;
  double best_density = 0;
  auto best = features_.end();
  for (auto feature = features_.begin(); feature != features_.end(); ++feature)
  {
    if (feature->sensor != seen.sensor || feature->category != seen.category) continue;
    known.any = true;
    // d(x, y) = range d(range, bearing)
    const double density = range * normalDensity(seen.mean - feature->mean, feature->covariance + seen.covariance);
    known.sum += density;
    if (isInView(feature->mean, reading)) known.in_view += 1, known.rates += 1;
    if (!(density > best_density)) continue;
    best = feature;
    best_density = density;
  }
  const FeatureMixture::Outcome outcome = mixture_.expect(known, uniform, reading.model.clutter_probability);
  mixture_.count(outcome);
  if (outcome.isKnown())
  {
    const Matrix2d gain = best->covariance * (best->covariance + seen.covariance).inverse();
    seen.mean = best->mean + gain * (seen.mean - best->mean);
    seen.covariance = best->covariance - gain * best->covariance;
    features_.erase(best);
  }
  features_.push_back(std::move(seen));
  if (features_.size() > kMaxPoints) features_.erase(features_.begin());
  return outcome;
}
}  // namespace mrpt_ext
