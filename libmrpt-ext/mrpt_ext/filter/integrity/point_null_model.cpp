#include "mrpt_ext/filter/integrity/point_null_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxPoints = 40;  // those not seen for longest are dropped
constexpr double kClearMatch = 0.5;     // share of the likeliest feature

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
  points_.move(nominalMotion(motion_, motion).increment, incrementCovariance(motion_, motion));
}

PointNullModel::Match PointNullModel::match(const Reading& reading, const Detection& detection) const
{
  const double range = *detection.range, bearing = *detection.bearing;
  const Matrix2d axes = rotation(reading.T_robot_sensor.phi + bearing);
  const Vector2d variances(square(detection.std_range), square(range * detection.std_bearing));
  Match result;
  result.position = transform(reading.T_robot_sensor, range * Vector2d(std::cos(bearing), std::sin(bearing)));
  result.covariance = axes * variances.asDiagonal() * axes.transpose();
  result.uniform = 1 / measurementVolume(detection, reading.model, max_range_);
  result.in_view.resize(features_.size(), false);
  double best = 0;
  for (std::size_t f = 0; f < features_.size(); ++f)
  {
    if (features_[f].sensor != reading.sensor || features_[f].category != detection.category) continue;
    const auto point = static_cast<Eigen::Index>(f);
    result.all.any = true;
    const double rate = 1 / (features_[f].missed + 2);
    // d(x, y) = range d(range, bearing)
    const double likelihood =
        rate * range *
        normalDensity(result.position - points_.position(point), points_.covariance(point) + result.covariance);
    result.all.sum += likelihood;
    result.in_view[f] = isInView(points_.position(point), reading);
    if (result.in_view[f]) result.all.in_view += 1, result.all.rates += rate;
    if (!(likelihood > best)) continue;
    best = likelihood;
    result.best = f;
  }
  if (result.best) result.share = best / result.all.sum;
  return result;
}

void PointNullModel::update(const Match& match)
{
  features_[*match.best].missed = 0;
  features_[*match.best].seen = ++detections_;
  // One taken for another would move all of them.
  if (match.share > kClearMatch)
    points_.update(static_cast<Eigen::Index>(*match.best), match.position, match.covariance);
}

void PointNullModel::add(const Reading& reading, const Detection& detection, const Match& match)
{
  features_.push_back({reading.sensor, detection.category, ++detections_});
  points_.add(match.position, match.covariance);
  if (features_.size() <= kMaxPoints) return;
  const auto oldest = std::min_element(features_.begin(), features_.end(),
                                       [](const auto& l, const auto& r) { return l.seen < r.seen; });
  points_.remove(oldest - features_.begin());
  features_.erase(oldest);
}

FeatureMixture::Outcome PointNullModel::observe(const Reading& reading, const Detection& detection)
{
  const Match found = match(reading, detection);
  const FeatureMixture::Outcome outcome = mixture_.expect(found.all, found.uniform, reading.model.clutter_probability);
  mixture_.count(outcome);
  for (std::size_t f = 0; f < features_.size(); ++f) features_[f].missed += found.in_view[f] ? 1 : 0;
  if (outcome.isKnown())
    update(found);
  else
    add(reading, detection, found);
  return outcome;
}

void PointNullModel::track(const Reading& reading, const Detection& detection)
{
  const Match found = match(reading, detection);
  if (FeatureMixture::recognizes(found.all, found.uniform, reading.model.clutter_probability)) update(found);
}
}  // namespace mrpt_ext
