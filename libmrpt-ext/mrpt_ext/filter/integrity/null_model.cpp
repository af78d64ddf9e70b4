#include "mrpt_ext/filter/integrity/null_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinRange = 0.2;         // [m]
constexpr std::size_t kMaxFeatures = 40;  // those not seen for longest are dropped

double normalDensity(double residual, double variance)
{
  return std::exp(-0.5 * residual * residual / variance) / std::sqrt(kTwoPi * variance);
}
}  // namespace

NullModel::NullModel(const MotionModel& motion, double max_range)
    : motion_(motion), max_range_(std::max(max_range, 2 * kMinRange))
{
}

void NullModel::move(const OdometryMotion& motion) { odometry_.move(motion_, motion); }

NullModel::PredictedBearing NullModel::predict(const TrackedFeature& feature, const Pose2& sensor,
                                               const SensorModel& model, const Detection& bearing) const
{
  RangeWeights predicted{};
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    const Vector2d ray = feature.position[k] - sensor.position();
    predicted[k] = wrap(std::atan2(ray.y(), ray.x()) - sensor.phi);
  }
  const double variance = square(bearing.std_bearing) + square(feature.std_bearing) +
                          std::max(0.0, odometry_.heading_variance - feature.heading_variance);
  PredictedBearing result;
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    // Each candidate represents the ranges half way to its neighbours.
    const double spread = 0.25 * wrap(predicted[std::min(k + 1, kRanges - 1)] - predicted[k > 0 ? k - 1 : 0]);
    const double density = normalDensity(wrap(*bearing.bearing - predicted[k]), variance + square(spread));
    if (std::abs(predicted[k]) <= model.field_of_view / 2) result.in_view += feature.weight[k];
    result.weight[k] = feature.weight[k] * density;
    result.density += result.weight[k];
  }
  if (result.density > 0)
    for (double& weight : result.weight) weight /= result.density;
  return result;
}

void NullModel::relocate(TrackedFeature& feature, const Pose2& sensor, const Detection& bearing,
                         const RangeWeights& ranges)
{
  const double direction = sensor.phi + *bearing.bearing;
  const Vector2d ray(std::cos(direction), std::sin(direction));
  for (std::size_t k = 0; k < kRanges; ++k) feature.position[k] = sensor.position() + ranges[k] * ray;
  feature.std_bearing = bearing.std_bearing;
  feature.heading_variance = odometry_.heading_variance;
}

void NullModel::add(const Reading& reading, const Pose2& sensor, const Detection& bearing)
{
  RangeWeights ranges{};
  for (std::size_t k = 0; k < kRanges; ++k)
    ranges[k] = kMinRange * std::pow(max_range_ / kMinRange, static_cast<double>(k) / (kRanges - 1));
  TrackedFeature feature{reading.sensor, bearing.category, {}, {}, 0, 0};
  feature.weight.fill(1.0 / kRanges);
  relocate(feature, sensor, bearing, ranges);
  features_.push_back(feature);
  if (features_.size() > kMaxFeatures) features_.erase(features_.begin());
}

NullModel::Match NullModel::match(const Reading& reading, const Detection& bearing) const
{
  Match result;
  result.sensor = compose(odometry_.pose, reading.T_robot_sensor);
  result.uniform = 1 / measurementVolume(bearing, reading.model, max_range_);
  for (std::size_t f = 0; f < features_.size(); ++f)
  {
    if (features_[f].sensor != reading.sensor || features_[f].category != bearing.category) continue;
    const PredictedBearing prediction = predict(features_[f], result.sensor, reading.model, bearing);
    result.all.any = true;
    result.all.in_view += prediction.in_view;
    result.all.sum += prediction.density;
    if (result.best && prediction.density <= result.prediction.density) continue;
    result.best = f;
    result.prediction = prediction;
  }
  return result;
}

void NullModel::update(const Match& match, const Detection& bearing)
{
  const auto best = features_.begin() + static_cast<std::ptrdiff_t>(*match.best);
  RangeWeights ranges{};
  for (std::size_t k = 0; k < kRanges; ++k) ranges[k] = (best->position[k] - match.sensor.position()).norm();
  best->weight = match.prediction.weight;
  relocate(*best, match.sensor, bearing, ranges);
  std::rotate(best, best + 1, features_.end());
}

FeatureMixture::Outcome NullModel::observe(const Reading& reading, const Detection& bearing)
{
  const Match found = match(reading, bearing);
  const FeatureMixture::Outcome outcome = mixture_.expect(found.all, found.uniform, reading.model.clutter_probability);
  mixture_.count(outcome);
  if (outcome.isKnown())
    update(found, bearing);
  else
    add(reading, found.sensor, bearing);
  return outcome;
}

void NullModel::track(const Reading& reading, const Detection& bearing)
{
  const Match found = match(reading, bearing);
  // One of the features in view against something else, both as likely beforehand: a mixture that has counted nothing.
  if (FeatureMixture().expect(found.all, found.uniform, reading.model.clutter_probability).isKnown())
    update(found, bearing);
}
}  // namespace mrpt_ext
