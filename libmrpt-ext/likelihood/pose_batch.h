#pragma once

#include <span>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Many robot poses at once, as a structure of arrays of equal length: x, y [m], phi [rad].
struct PoseBatch
{
  std::span<const double> x, y, phi;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Pose2 operator[](std::size_t i) const { return {x[i], y[i], phi[i]}; }
};
}  // namespace mrpt_ext
