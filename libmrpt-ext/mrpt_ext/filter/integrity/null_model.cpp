#include "mrpt_ext/filter/integrity/null_model.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr double kNearest = 0.2;         // [m]
constexpr std::size_t kMostThings = 40;  // the oldest are forgotten

double normalDensity(double residual, double variance)
{
  return std::exp(-0.5 * residual * residual / variance) / std::sqrt(kTwoPi * variance);
}
}  // namespace

NullModel::NullModel(const MotionModel& motion, double max_range)
    : motion_(motion), max_range_(std::max(max_range, 2 * kNearest))
{
}

void NullModel::move(const OdometryMotion& motion) { odometry_.move(motion_, motion); }

NullModel::Expected NullModel::expect(const Thing& thing, const Pose2& sensor, const SensorModel& model,
                                      const Detection& bearing) const
{
  std::array<double, kRanges> seen_at{};
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    const Vector2d away = thing.where[k] - sensor.position();
    seen_at[k] = wrap(std::atan2(away.y(), away.x()) - sensor.phi);
  }
  const double variance = square(bearing.std_bearing) + square(thing.std_bearing) +
                          std::max(0.0, odometry_.heading_variance - thing.heading_variance);
  Expected expected;
  for (std::size_t k = 0; k < kRanges; ++k)
  {
    // Each range stands for those half way to its neighbours.
    const double spread = 0.25 * wrap(seen_at[std::min(k + 1, kRanges - 1)] - seen_at[k > 0 ? k - 1 : 0]);
    const double density = normalDensity(wrap(*bearing.bearing - seen_at[k]), variance + square(spread));
    if (std::abs(seen_at[k]) <= model.field_of_view / 2) expected.in_view += thing.share[k];
    expected.share[k] = thing.share[k] * density;
    expected.density += expected.share[k];
  }
  if (expected.density > 0)
    for (double& share : expected.share) share /= expected.density;
  return expected;
}

void NullModel::place(Thing& thing, const Pose2& sensor, const Detection& bearing,
                      const std::array<double, kRanges>& ranges)
{
  const double direction = sensor.phi + *bearing.bearing;
  const Vector2d ray(std::cos(direction), std::sin(direction));
  for (std::size_t k = 0; k < kRanges; ++k) thing.where[k] = sensor.position() + ranges[k] * ray;
  thing.std_bearing = bearing.std_bearing;
  thing.heading_variance = odometry_.heading_variance;
}

double NullModel::take(const Reading& reading, const Detection& bearing)
{
  const Pose2 sensor = compose(odometry_.pose, reading.T_robot_sensor);
  const double even = 1 / measurementVolume(bearing, reading.model, max_range_);
  double in_view = 0, of_things = 0;
  Thing* likeliest = nullptr;
  Expected as_seen;
  for (Thing& thing : things_)
  {
    if (thing.sensor != reading.sensor || thing.category != bearing.category) continue;
    const Expected expected = expect(thing, sensor, reading.model, bearing);
    in_view += expected.in_view;
    of_things += expected.density;
    if (!likeliest || expected.density > as_seen.density)
    {
      likeliest = &thing;
      as_seen = expected;
    }
  }
  const double p_new = likeliest ? (new_ones_ + 1) / (taken_ + 2) : 1;  // Laplace's rule of succession
  const double each = (1 - p_new) / std::max(1.0, in_view);
  const double clutter = reading.model.clutter_probability;
  const double density = clutter * even + (1 - clutter) * (p_new * even + each * of_things);

  taken_ += 1;
  std::array<double, kRanges> ranges{};
  if (likeliest && each * as_seen.density > p_new * even)
  {
    for (std::size_t k = 0; k < kRanges; ++k) ranges[k] = (likeliest->where[k] - sensor.position()).norm();
    likeliest->share = as_seen.share;
    place(*likeliest, sensor, bearing, ranges);
  }
  else
  {
    new_ones_ += 1;
    for (std::size_t k = 0; k < kRanges; ++k)
      ranges[k] = kNearest * std::pow(max_range_ / kNearest, static_cast<double>(k) / (kRanges - 1));
    Thing thing{reading.sensor, bearing.category, {}, {}, 0, 0};
    thing.share.fill(1.0 / kRanges);
    place(thing, sensor, bearing, ranges);
    things_.push_back(thing);
    if (things_.size() > kMostThings) things_.erase(things_.begin());
  }
  return std::log(density);
}
}  // namespace mrpt_ext
