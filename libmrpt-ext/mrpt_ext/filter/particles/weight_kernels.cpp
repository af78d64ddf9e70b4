#include "mrpt_ext/filter/particles/weight_kernels.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLanes = 16, kChunk = 1024;  // sums of a chunk are in single precision, lane by lane
using Lanes [[gnu::vector_size(kLanes * sizeof(float))]] = float;

/// Differences to -87 and below count as nothing.
[[gnu::always_inline]] inline float weightOf(float log_weight, float reference)
{
  const float difference = log_weight - reference;
  return difference > -87.0F ? vector_math::expOf(difference) : 0.0F;
}

MRPT_EXT_VECTOR_CLONES
float largestInLanes(const float* values, std::size_t count)
{
  float lanes[kLanes];
  std::fill_n(lanes, kLanes, -std::numeric_limits<float>::infinity());
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (std::size_t l = 0; l < kLanes; ++l) lanes[l] = values[i + l] > lanes[l] ? values[i + l] : lanes[l];
  for (; i < count; ++i) lanes[0] = values[i] > lanes[0] ? values[i] : lanes[0];
  return *std::max_element(lanes, lanes + kLanes);
}

MRPT_EXT_VECTOR_CLONES
void fillWeights(const float* log_weights, std::size_t count, float reference, float* weights)
{
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < count; ++i) weights[i] = weightOf(log_weights[i], reference);
}

MRPT_EXT_VECTOR_CLONES
WeightSums chunkSums(const float* weights, std::size_t count)
{
  Lanes first{}, second{};
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes)
  {
    Lanes w;
    std::memcpy(&w, weights + i, sizeof w);
    first += w;
    second += w * w;
  }
  WeightSums sums;
  for (; i < count; ++i) sums += {double{weights[i]}, square(double{weights[i]})};
  for (std::size_t l = 0; l < kLanes; ++l) sums += {double{first[l]}, double{second[l]}};
  return sums;
}
}  // namespace

float largestOf(std::span<const float> values) { return largestInLanes(values.data(), values.size()); }

double exponentials(std::span<const float> log_weights, float reference, std::span<float> weights)
{
  fillWeights(log_weights.data(), log_weights.size(), reference, weights.data());
  double sum = 0;
  for (std::size_t first = 0; first < weights.size(); first += kChunk)
    sum += chunkSums(weights.data() + first, std::min(kChunk, weights.size() - first)).first;
  return sum;
}

void subtractAll(std::span<float> values, float first, float second)
{
  for (float& value : values) value = (value - first) - second;
}

WeightSums weightSums(std::span<const float> log_weights, float reference)
{
  alignas(64) float weights[kChunk];
  WeightSums total;
  for (std::size_t first = 0; first < log_weights.size(); first += kChunk)
  {
    const std::size_t count = std::min(kChunk, log_weights.size() - first);
    fillWeights(log_weights.data() + first, count, reference, weights);
    total += chunkSums(weights, count);
  }
  return total;
}
}  // namespace mrpt_ext
