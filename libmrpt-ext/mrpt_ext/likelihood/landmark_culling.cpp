#include "mrpt_ext/likelihood/landmark_culling.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRounding = 1e-5;        // [rad] and relative: single precision must not cut off what belongs inside
constexpr std::uint64_t kCostOfView = 6;  // operations, of a landmark
constexpr float kPiF = 3.14159265F;

struct Interval
{
  float low, high;
};

Interval intervalOf(std::span<const SensorTile> tiles, const SensorTile::Column SensorTile::*column)
{
  Interval interval{(tiles[0].*column)[0], (tiles[0].*column)[0]};
  for (const SensorTile& tile : tiles)
  {
    const auto [low, high] = std::minmax_element(std::begin(tile.*column), std::end(tile.*column));
    interval = {std::min(interval.low, *low), std::max(interval.high, *high)};
  }
  return interval;
}

struct Sector
{
  double middle = 0, half = kPi;
};

/// Smallest sector about the mean direction that holds all headings.
Sector sectorOf(std::span<const SensorTile> tiles, const SensorTile::Column SensorTile::*cosine,
                const SensorTile::Column SensorTile::*sine)
{
  double c = 0, s = 0;
  for (const SensorTile& tile : tiles)
    for (std::size_t i = 0; i < SensorTile::kSize; ++i)
    {
      c += double{(tile.*cosine)[i]};
      s += double{(tile.*sine)[i]};
    }
  const double length = std::hypot(c, s);
  if (!(length > 0)) return {};
  const auto mc = static_cast<float>(c / length), ms = static_cast<float>(s / length);
  float least = 1;
  for (const SensorTile& tile : tiles)
    for (std::size_t i = 0; i < SensorTile::kSize; ++i)
      least = std::min(least, mc * (tile.*cosine)[i] + ms * (tile.*sine)[i]);
  // The cosine of a small angle is blunt: 1e-6 of it are 1.4e-3 rad.
  return {std::atan2(s, c), std::acos(std::clamp(double{least} - 1e-6, -1.0, 1.0))};
}

/// Directions to, and distances of, the landmarks from the middle of the sensors.
MRPT_EXT_VECTOR_CLONES
void directionsFrom(float x, float y, float radius, std::size_t count, const float* landmark_x, const float* landmark_y,
                    float* direction, float* half_width, float* distance)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t j = 0; j < count; ++j)
  {
    const float dx = landmark_x[j] - x, dy = landmark_y[j] - y, d = std::sqrt(dx * dx + dy * dy);
    const float share = radius / (d > radius ? d : radius);
    direction[j] = vector_math::angleOf(dy, dx);
    // asin(share) <= share (1 + (pi / 2 - 1) share^2); from inside the circle all directions are possible
    half_width[j] = share < 1.0F ? share * (1.0F + 0.57079633F * share * share) : kPiF;
    distance[j] = d;
  }
}
}  // namespace

SensorBounds boundsOf(std::span<const SensorTile> tiles)
{
  const Interval x = intervalOf(tiles, &SensorTile::x), y = intervalOf(tiles, &SensorTile::y);
  const Interval scale = intervalOf(tiles, &SensorTile::range_scale),
                 shift = intervalOf(tiles, &SensorTile::range_shift);
  const Sector heading = sectorOf(tiles, &SensorTile::cosine, &SensorTile::sine);
  const Sector bearing_frame = sectorOf(tiles, &SensorTile::bearing_frame_cosine, &SensorTile::bearing_frame_sine);
  const double half_x = 0.5 * (double{x.high} - double{x.low}), half_y = 0.5 * (double{y.high} - double{y.low});
  return {.x = double{x.low} + half_x,
          .y = double{y.low} + half_y,
          .radius = std::hypot(half_x, half_y) * (1 + kRounding) + 1e-9,
          .heading = heading.middle,
          .half_turn = heading.half,
          .bearing_heading = bearing_frame.middle,
          .bearing_half_turn = bearing_frame.half,
          .scale_low = scale.low,
          .scale_high = scale.high,
          .shift_low = shift.low,
          .shift_high = shift.high};
}

LandmarkCulling::LandmarkCulling(const LandmarkTable& map, const ScoringFrame& frame)
{
  const double sensor_covariance =
      Eigen::SelfAdjointEigenSolver<Matrix2d>(frame.sensor_covariance).eigenvalues().maxCoeff();
  for (const Landmark& landmark : map.all())
  {
    const double rise = frame.horizontal_range ? 0.0 : landmark.position.z() - frame.sensor_height;
    x_.push_back(static_cast<float>(landmark.position.x() - frame.origin.x()));
    y_.push_back(static_cast<float>(landmark.position.y() - frame.origin.y()));
    rise2_.push_back(static_cast<float>(square(rise)));
    spread_.push_back(static_cast<float>(square(landmark.stddev.maxCoeff()) + std::max(0.0, sensor_covariance)));
  }
  for (auto* column : {&direction_, &half_width_, &nearest_, &farthest_, &bearing_spread_}) column->resize(x_.size());
}

void LandmarkCulling::update(const SensorBounds& bounds, const VisibilityLimits& limits)
{
  bounds_ = bounds;
  WorkCounter::add(kCostOfView * x_.size());
  const auto radius = static_cast<float>(bounds.radius);
  directionsFrom(static_cast<float>(bounds.x), static_cast<float>(bounds.y), radius, x_.size(), x_.data(), y_.data(),
                 direction_.data(), half_width_.data(), nearest_.data());
  for (std::size_t j = 0; j < x_.size(); ++j)
  {
    const float distance = nearest_[j], least = std::max(0.0F, distance - radius), most = distance + radius;
    bearing_spread_[j] = least > 0 ? spread_[j] / (least * least) : spread_[j] > 0 ? HUGE_VALF : 0.0F;
    nearest_[j] = std::sqrt(least * least + rise2_[j]) * static_cast<float>(1 - kRounding);
    farthest_[j] = std::sqrt(most * most + rise2_[j]) * static_cast<float>(1 + kRounding);
  }
  classify(limits);
}

void LandmarkCulling::classify(const VisibilityLimits& limits)
{
  in_view_.assign(x_.size(), InView::all);
  if (!limits.any()) return;
  for (std::size_t j = 0; j < x_.size(); ++j)
  {
    const double off_axis = std::abs(wrap(double{direction_[j]} - bounds_.heading));
    const double half = double{half_width_[j]} + bounds_.half_turn + kRounding;
    const auto share = [](double offset, double slope, double value) { return offset - slope * value; };
    const double most = std::min(share(limits.range_offset, limits.range_slope, double{nearest_[j]}),
                                 share(limits.bearing_offset, limits.bearing_slope, std::max(0.0, off_axis - half)));
    const double least = std::min(share(limits.range_offset, limits.range_slope, double{farthest_[j]}),
                                  share(limits.bearing_offset, limits.bearing_slope, std::min(kPi, off_axis + half)));
    in_view_[j] = most <= 0 ? InView::no : least >= 1 ? InView::all : InView::some;
  }
}

void LandmarkCulling::findNear(const Detection& detection, double cut, std::span<const std::uint32_t> candidates,
                               std::vector<std::uint32_t>& near) const
{
  const auto bearing = static_cast<float>(wrap(detection.bearing.value_or(0) + bounds_.bearing_heading));
  const auto turn = static_cast<float>(bounds_.bearing_half_turn + kRounding), c = static_cast<float>(cut);
  const auto var_bearing = static_cast<float>(square(detection.std_bearing));
  const auto var_range = static_cast<float>(square(detection.std_range));
  const auto scale_low = static_cast<float>(bounds_.scale_low), scale_high = static_cast<float>(bounds_.scale_high);
  const auto shift_low = static_cast<float>(bounds_.shift_low), shift_high = static_cast<float>(bounds_.shift_high);
  const auto range = static_cast<float>(detection.range.value_or(0));
  const float plain_gate = c * std::sqrt(var_bearing), plain_reach = c * std::sqrt(var_range);
  WorkCounter::add(candidates.size());
  for (const std::uint32_t j : candidates)
  {
    if (in_view_[j] == InView::no) continue;
    if (detection.bearing)
    {
      const float spread = bearing_spread_[j];
      const float gate = spread > 0 ? c * std::sqrt(var_bearing + spread) : plain_gate;
      const float apart = std::abs(direction_[j] - bearing), error = std::min(apart, 2 * kPiF - apart);
      if (error > gate + turn + half_width_[j]) continue;
    }
    if (detection.range)
    {
      const float reach = spread_[j] > 0 ? c * std::sqrt(var_range + spread_[j]) : plain_reach;
      const float low = scale_low * nearest_[j] + shift_low, high = scale_high * farthest_[j] + shift_high;
      if (range < low - reach || range > high + reach) continue;
    }
    near.push_back(j);
  }
}
}  // namespace mrpt_ext
