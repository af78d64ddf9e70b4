#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

/// Elementary functions in single precision as straight-line code, so that loops over them become vector code on every
/// instruction set. Polynomials: least-squares fits with weights moved towards the largest error until it is level.
/// Errors are relative unless said otherwise, found over the whole stated domain. No error is ever raised; arguments
/// outside the domain give a finite, meaningless value.
namespace mrpt_ext::vector_math
{
inline constexpr float kWholeShift = 12582912.0F;  // 1.5 * 2^23: a float this large has no bits after the point

/// Nearest whole number to |x| < 2^22, by the rounding of the addition itself.
[[gnu::always_inline]] inline float nearestWhole(float x) { return (x + kWholeShift) - kWholeShift; }

/// 2^x for x <= 127, to 2e-7; below -126: 2^-126.
[[gnu::always_inline]] inline float exp2Of(float x)
{
  const float bounded = x > -126.0F ? x : -126.0F;
  const float shifted = bounded + kWholeShift, r = bounded - (shifted - kWholeShift);
  float p = 0.00132647242F;
  p = p * r + 0.00967151324F;
  p = p * r + 0.0555073376F;
  p = p * r + 0.240222421F;
  p = p * r + 0.693146978F;
  p = p * r + 1.0F;
  const std::uint32_t exponent = std::bit_cast<std::uint32_t>(shifted) << 23;  // its lowest bits are the whole number
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(p) + exponent);
}

/// e^x for -87 <= x <= 88, to 2e-7 + |x| * 1e-7.
[[gnu::always_inline]] inline float expOf(float x) { return exp2Of(x * 1.44269504F); }

/// Natural logarithm of a normal positive number, to 3e-7 of the larger of the result and 1e-7.
[[gnu::always_inline]] inline float logOf(float x)
{
  constexpr std::int32_t kRootHalf = 0x3f3504f3;  // mantissas are taken from sqrt(1/2) to sqrt(2)
  const std::int32_t bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - kRootHalf) >> 23;
  const float t = std::bit_cast<float>(bits - exponent * 0x800000) - 1.0F;
  float p = 0.089187488F;
  p = p * t - 0.143496527F;
  p = p * t + 0.14876391F;
  p = p * t - 0.165656943F;
  p = p * t + 0.199654642F;
  p = p * t - 0.250017454F;
  p = p * t + 0.333338561F;
  const float e = static_cast<float>(exponent), t2 = t * t;
  return e * 0.693359375F + (t + (e * -2.12194440e-4F + (t2 * t * p - 0.5F * t2)));
}

struct SineCosine
{
  float sine, cosine;
};

/// Of |angle| < 1000 rad, to 1e-7 absolute (the angle's own rounding apart).
[[gnu::always_inline]] inline SineCosine sineCosineOf(float angle)
{
  const float quarter = nearestWhole(angle * 0.636619772F);
  // pi / 2 in three parts, so that the products are exact
  const float r = ((angle - quarter * 1.5703125F) - quarter * 4.83751297e-4F) - quarter * 7.54978995e-8F;
  const float z = r * r;
  const float s = r + r * z * (-0.16666655F + z * (0.00833218084F - z * 0.000195175909F));
  const float c = 1.0F - 0.5F * z + z * z * (0.0416666471F + z * (-0.00138873779F + z * 2.44394803e-05F));
  const auto turn = static_cast<std::int32_t>(quarter);
  const bool swapped = (turn & 1) != 0;
  const float sine = swapped ? c : s, cosine = swapped ? s : c;
  return {(turn & 2) != 0 ? -sine : sine, ((turn + 1) & 2) != 0 ? -cosine : cosine};
}

/// Angle of (x, y) in [-pi, pi], to 3e-7 rad; 0 for (0, 0).
[[gnu::always_inline]] inline float angleOf(float y, float x)
{
  const float ax = std::abs(x), ay = std::abs(y);
  const float large = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
  const float t = small / (large > 1e-30F ? large : 1e-30F), z = t * t;
  float p = 0.00298225448F;
  p = p * z - 0.0166127259F;
  p = p * z + 0.0436065481F;
  p = p * z - 0.0758524717F;
  p = p * z + 0.106812369F;
  p = p * z - 0.142148281F;
  p = p * z + 0.199942195F;
  p = p * z - 0.333331709F;
  float angle = t + t * z * p;
  angle = ay > ax ? 1.57079633F - angle : angle;
  angle = x < 0 ? 3.14159265F - angle : angle;
  return y < 0 ? -angle : angle;
}

/// Square of an angle up to 30 degrees from the square of its sine, to 4e-7; for larger sines a value that grows with
/// them and lies between 30 and 90 degrees squared.
[[gnu::always_inline]] inline float squaredAngleOf(float squared_sine)
{
  const float f = squared_sine;
  const float p = 0.333302674F + f * (0.178915413F + f * (0.101410706F + f * 0.135688394F));
  return f + f * f * p;
}
}  // namespace mrpt_ext::vector_math
