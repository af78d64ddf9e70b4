#pragma once

#include <cstddef>

namespace mrpt_ext::limit
{
/// Position from `bearings` bearings and nothing else: paper 000, eq 1-6, on unit vectors. No heading, no quality, no
/// look at which way the bearings point, no answer for singular cases. `landmarks` (x, y) and `units` (c, s) of one
/// problem after the other, without gaps. Returns the sum of all coordinates found. Compiled for the processor that
/// builds it.
double sumOfLinearPositions(const double* landmarks, const double* units, std::size_t bearings, std::size_t count);
}  // namespace mrpt_ext::limit
