#include "mrpt_ext/correspondence/bearings/direction_intervals.h"

#include <cstddef>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"

namespace mrpt_ext
{
namespace
{
constexpr auto kPiF = static_cast<float>(kPi);

/// Not below asin(u): 1.05 u up to a half (asin(1/2) = 1.0472 / 2), a quarter turn up to 1, any direction beyond.
[[gnu::always_inline]] inline float widthOf(float u)
{
  const float wide = u < 1 ? 0.5F * kPiF : kPiF;
  return u <= 0.5F ? 1.05F * u : wide;
}

MRPT_EXT_VECTOR_CLONES
void intervals(const float* x, const float* y, std::size_t count, float px, float py, float radius, float farthest,
               float* directions, float* half_width)
{
  for (std::size_t l = 0; l < count; ++l)
  {
    const float dx = x[l] - px, dy = y[l] - py;
    const float distance = __builtin_sqrtf(dx * dx + dy * dy);
    const float width = widthOf(radius / (distance > 1e-9F ? distance : 1e-9F));
    directions[l] = vector_math::angleOf(dy, dx);
    half_width[l] = distance <= farthest ? width : -1.0F;
  }
}
}  // namespace

DirectionIntervals::DirectionIntervals(const std::vector<Vector2d>& landmarks, const Vector2d& middle) : middle_(middle)
{
  for (const Vector2d& landmark : landmarks)
  {
    x_.push_back(static_cast<float>(landmark.x() - middle.x()));
    y_.push_back(static_cast<float>(landmark.y() - middle.y()));
  }
  direction_.resize(landmarks.size());
  half_width_.resize(landmarks.size());
}

void DirectionIntervals::update(const Vector2d& centre, double radius, double farthest)
{
  intervals(x_.data(), y_.data(), x_.size(), static_cast<float>(centre.x() - middle_.x()),
            static_cast<float>(centre.y() - middle_.y()), static_cast<float>(radius), static_cast<float>(farthest),
            direction_.data(), half_width_.data());
}
}  // namespace mrpt_ext
