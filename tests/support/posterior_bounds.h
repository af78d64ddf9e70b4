#pragma once

#include <vector>

#include "mrpt_ext/evaluation/posterior_bound.h"

namespace mrpt_ext::testing
{
/// The posterior Cramer-Rao bound after each step.
inline std::vector<Matrix3d> posteriorBounds(const Pose2& start, const Matrix3d& prior,
                                             const std::vector<BoundStep>& steps)
{
  std::vector<Matrix3d> bounds;
  BoundRecursion bound(start, prior);
  for (const BoundStep& step : steps) bounds.push_back(bound.advance(step));
  return bounds;
}
}  // namespace mrpt_ext::testing
