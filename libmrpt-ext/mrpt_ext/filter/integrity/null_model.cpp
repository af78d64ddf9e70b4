#include "mrpt_ext/filter/integrity/null_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

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
/// That a bearing with a normal distribution is within the field of view.
double probabilityInView(double mean, double std, double field_of_view)
{
  if (field_of_view >= kTwoPi) return 1;
  const auto above = [&](double limit) { return 0.5 * std::erfc((limit - mean) / (std * std::numbers::sqrt2)); };
  return above(-field_of_view / 2) - above(field_of_view / 2);
}
}  // namespace

NullModel::NullModel(const MotionModel& motion, double max_range)
    : motion_(motion), max_range_(std::max(max_range, 2 * kMinRange))
{
}

void NullModel::move(const OdometryMotion& motion)
{
  const double before = odometry_.heading_variance;
  odometry_.move(motion_, motion);
  errors_.turn(odometry_.heading_variance - before);
}

NullModel::Candidates NullModel::candidatesOf(const TrackedFeature& feature, const Pose2& sensor)
{
  const Vector2d baseline = feature.anchor - sensor.position();
  const Vector2d ray(std::cos(feature.direction), std::sin(feature.direction));
  Candidates candidates;
  for (std::size_t k = 0; k < kRanges; ++k) candidates[k] = baseline + feature.range[k] * ray;
  return candidates;
}

NullModel::PredictedBearing NullModel::predict(std::size_t index, const Pose2& sensor, const SensorModel& model,
                                               const Detection& bearing) const
{
  const TrackedFeature& feature = features_[index];
  const Candidates candidates = candidatesOf(feature, sensor);
  RangeWeights predicted{}, innovation{};
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    predicted[k] = wrap(std::atan2(candidates[k].y(), candidates[k].x()) - sensor.phi);
    innovation[k] = wrap(*bearing.bearing - predicted[k]);
  }
  const double variance = square(bearing.std_bearing) + errors_.bearingVariance(static_cast<Eigen::Index>(index));
  PredictedBearing result;
  double within = 0;  // of each candidate, given the bearing
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    // Each candidate represents the ranges half way to its neighbours.
    const double spread = 0.25 * wrap(predicted[std::min(k + 1, kRanges - 1)] - predicted[k > 0 ? k - 1 : 0]);
    const double total = variance + square(spread);
    result.in_view += feature.weight[k] * probabilityInView(predicted[k], std::sqrt(total), model.field_of_view);
    result.weight[k] = feature.weight[k] * normalDensity(innovation[k], total);
    result.density += result.weight[k];
    within += result.weight[k] * square(spread) * variance / total;
  }
  if (result.density <= 0) return result;
  double squares = 0;
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    result.weight[k] /= result.density;
    result.innovation += result.weight[k] * innovation[k];
    squares += result.weight[k] * square(innovation[k]);
  }
  result.spread = std::max(0.0, squares - square(result.innovation)) + within / result.density;
  return result;
}

void NullModel::dropOldest()
{
  const auto oldest = std::min_element(features_.begin(), features_.end(),
                                       [](const auto& l, const auto& r) { return l.seen < r.seen; });
  errors_.remove(oldest - features_.begin());
  features_.erase(oldest);
}

void NullModel::add(const Reading& reading, const Pose2& sensor, const Detection& bearing)
{
  TrackedFeature feature{reading.sensor, bearing.category, sensor.position(), sensor.phi + *bearing.bearing, {}, {},
                         ++bearings_};
  for (std::size_t k = 0; k < kRanges; ++k)
    feature.range[k] = kMinRange * std::pow(max_range_ / kMinRange, static_cast<double>(k) / (kRanges - 1));
  feature.weight.fill(1.0 / kRanges);
  features_.push_back(feature);
  errors_.add(square(bearing.std_bearing));
  if (features_.size() > kMaxFeatures) dropOldest();
}

NullModel::Match NullModel::match(const Reading& reading, const Detection& bearing) const
{
  Match result;
  result.sensor = compose(odometry_.pose, reading.T_robot_sensor);
  result.in_view.resize(features_.size(), 0.0);
  double best = 0;
  result.uniform = 1 / measurementVolume(bearing, reading.model, max_range_);
  for (std::size_t f = 0; f < features_.size(); ++f)
  {
    if (features_[f].sensor != reading.sensor || features_[f].category != bearing.category) continue;
    const PredictedBearing prediction = predict(f, result.sensor, reading.model, bearing);
    result.all.any = true;
    const double rate = 1 / (features_[f].missed + 2), likelihood = rate * prediction.density;
    result.in_view[f] = prediction.in_view;
    result.all.in_view += prediction.in_view;
    result.all.rates += rate * prediction.in_view;
    result.all.sum += likelihood;
    if (result.best && likelihood <= best) continue;
    best = likelihood;
    result.best = f;
    result.prediction = prediction;
  }
  return result;
}

void NullModel::countMissed(const Match& match)
{
  for (std::size_t f = 0; f < features_.size(); ++f) features_[f].missed += match.in_view[f];
}

void NullModel::update(const Match& match, const Detection& bearing)
{
  const PredictedBearing& predicted = match.prediction;
  TrackedFeature& best = features_[*match.best];
  const Candidates candidates = candidatesOf(best, match.sensor);
  for (std::size_t k = 0; k < kRanges; ++k) best.range[k] = candidates[k].norm();
  best.weight = predicted.weight;
  best.anchor = match.sensor.position();
  best.direction = match.sensor.phi + *bearing.bearing - predicted.innovation;
  best.seen = ++bearings_;
  best.missed = 0;
  const auto correction = errors_.update(static_cast<Eigen::Index>(*match.best), predicted.innovation,
                                         square(bearing.std_bearing), predicted.spread);
  odometry_.pose.phi = wrap(odometry_.pose.phi + correction.heading);
  for (std::size_t f = 0; f < features_.size(); ++f)
    features_[f].direction = wrap(features_[f].direction + correction.directions(static_cast<Eigen::Index>(f)));
}

FeatureMixture::Outcome NullModel::observe(const Reading& reading, const Detection& bearing)
{
  const Match found = match(reading, bearing);
  const FeatureMixture::Outcome outcome = mixture_.expect(found.all, found.uniform, reading.model.clutter_probability);
  mixture_.count(outcome);
  countMissed(found);
  if (outcome.isKnown())
    update(found, bearing);
  else
    add(reading, found.sensor, bearing);
  return outcome;
}

void NullModel::track(const Reading& reading, const Detection& bearing)
{
  const Match found = match(reading, bearing);
  if (FeatureMixture::recognizes(found.all, found.uniform, reading.model.clutter_probability)) update(found, bearing);
}
}  // namespace mrpt_ext
