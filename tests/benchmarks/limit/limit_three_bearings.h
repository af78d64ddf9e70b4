#pragma once

#include <cstddef>

namespace mrpt_ext::limit
{
/// Position from three bearings and nothing else: ToTal (Pierlot, Van Droogenbroeck 2014) on unit vectors with the
/// cotangents multiplied out. No heading, no look at which way the bearings point, no answer for singular cases.
/// All of it is compiled for the processor that builds it.

/// One problem after the other: `at` = {x1, y1, x2, y2, x3, y3} and `u` = {c1, s1, c2, s2, c3, s3} of each, without
/// gaps. Returns the sum of all coordinates found.
double sumOfTotalPositions(const double* at, const double* u, std::size_t count);

/// Several at a time: element k of `in` is the array of the k-th number of {at, u}.
void totalPositions(const float* const (&in)[12], std::size_t count, float* x, float* y);
void totalPositions(const double* const (&in)[12], std::size_t count, double* x, double* y);
}  // namespace mrpt_ext::limit
