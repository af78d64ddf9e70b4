#pragma once

#include <string>

#include "mrpt_ext/solvers/two_circles.h"

namespace mrpt_ext
{
/// Name of a relation in the golden vectors.
inline std::string toString(CircleRelation relation)
{
  constexpr const char* kNames[] = {"two",        "tangent",    "separate",        "contained",
                                    "concentric", "coincident", "negative_radius", "not_finite"};
  return kNames[static_cast<std::size_t>(relation)];
}
}  // namespace mrpt_ext
