#include "mrpt_ext/solvers/origin_correction.h"

#include <algorithm>

namespace mrpt_ext
{
OriginCorrection calibrateAtOrigin(const Vector2d& p_at_origin, const Vector2d& q_at_origin, const PoleField& field)
{
  OriginCorrection result;
  const bool finite = p_at_origin.allFinite() && q_at_origin.allFinite() && std::isfinite(field.depth);
  if (!finite || !(field.half_width > 0) || !std::isfinite(field.half_width)) return result;
  const double smallest = std::min(p_at_origin.cwiseAbs().minCoeff(), q_at_origin.cwiseAbs().minCoeff());
  result.status = SolveStatus::degenerate;
  if (smallest <= 1e-9 * field.half_width) return result;
  result.status = SolveStatus::ok;
  result.p_factor = Vector2d(-field.half_width, field.depth).cwiseQuotient(p_at_origin);
  result.q_factor = Vector2d(field.half_width, field.depth).cwiseQuotient(q_at_origin);
  return result;
}
}  // namespace mrpt_ext
