#pragma once

#include <span>

namespace mrpt_ext
{
/// Largest value; -infinity when empty.
[[nodiscard]] float largestOf(std::span<const float> values);

/// weights[i] = exp(log_weights[i] - reference); returns their sum. 3e-7 relative each; below e^-87 it is 0.
double exponentials(std::span<const float> log_weights, float reference, std::span<float> weights);

/// values[i] = (values[i] - first) - second
void subtractAll(std::span<float> values, float first, float second);

/// Sum of exp(log_weight) and of its square.
struct WeightSums
{
  double first = 0, second = 0;

  void operator+=(const WeightSums& more)
  {
    first += more.first;
    second += more.second;
  }
};
[[nodiscard]] WeightSums weightSums(std::span<const float> log_weights, float reference);
}  // namespace mrpt_ext
