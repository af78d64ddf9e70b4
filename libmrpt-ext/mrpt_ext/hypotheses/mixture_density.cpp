#include "mrpt_ext/hypotheses/mixture_density.h"

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr float kFullTurn = 6.28318531F;

[[gnu::always_inline]] inline float gaussianOf(const MixtureTerm& t, float dx, float dy, float turned)
{
  const float exponent =
      dx * (t.xx * dx + t.xy * dy + t.xphi * turned) + dy * (t.yy * dy + t.yphi * turned) + t.phiphi * turned * turned;
  return vector_math::exp2Of(t.log2_peak + exponent);
}

template <bool FullTurns>
[[gnu::always_inline]] inline void addTo(const MixtureTerm& term, const float* x, const float* y, const float* phi,
                                         float* density, std::size_t count)
{
  const MixtureTerm t = term;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < count; ++i)
  {
    const float dx = x[i] - t.x, dy = y[i] - t.y, difference = phi[i] - t.phi;
    const float turned = difference - kFullTurn * vector_math::nearestWhole(difference * (1 / kFullTurn));
    float sum = gaussianOf(t, dx, dy, turned);
    if constexpr (FullTurns)
      sum += gaussianOf(t, dx, dy, turned - kFullTurn) + gaussianOf(t, dx, dy, turned + kFullTurn);
    density[i] += sum;
  }
}

MRPT_EXT_VECTOR_CLONES
void addNarrow(const MixtureTerm& term, const float* x, const float* y, const float* phi, float* density,
               std::size_t count)
{
  addTo<false>(term, x, y, phi, density, count);
}

MRPT_EXT_VECTOR_CLONES
void addWide(const MixtureTerm& term, const float* x, const float* y, const float* phi, float* density,
             std::size_t count)
{
  addTo<true>(term, x, y, phi, density, count);
}
}  // namespace

void addDensity(const MixtureTerm& term, std::span<const float> x, std::span<const float> y, std::span<const float> phi,
                std::span<float> density)
{
  WorkCounter::add(density.size());
  const auto add = term.full_turns ? addWide : addNarrow;
  add(term, x.data(), y.data(), phi.data(), density.data(), density.size());
}
}  // namespace mrpt_ext
