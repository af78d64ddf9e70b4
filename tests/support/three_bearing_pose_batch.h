#pragma once

#include <array>
#include <cstddef>

namespace mrpt_ext
{
/// Many problems of three bearings, an array for each quantity: element m of x[i] belongs to landmark i of problem m.
template <class Real>
struct ThreeBearingArrays
{
  std::array<const Real*, 3> x{}, y{};  ///< landmarks [m], world frame
  std::array<const Real*, 3> c{}, s{};  ///< unit vectors of the bearings, robot frame
  std::size_t count = 0;
};

/// Where the answers go, each of `count` elements; they must not overlap the problems or each other.
template <class Real>
struct PositionArrays
{
  Real *x = nullptr, *y = nullptr;  ///< [m], world frame; 0 without a pose
  Real* valid = nullptr;            ///< 1: a pose; 0: behind or degenerate (as wide as the rest: vectors stay whole)
};

template <class Real>
struct HeadingArrays
{
  Real *c = nullptr, *s = nullptr;  ///< cosine and sine of the heading; 1 and 0 without a pose
};

/// solveThreeBearingPose() (three_bearing_pose.h) for all problems, several at a time, without branches.
void positionsFromThreeBearings(const ThreeBearingArrays<float>& problems, const PositionArrays<float>& positions);
void positionsFromThreeBearings(const ThreeBearingArrays<double>& problems, const PositionArrays<double>& positions);

/// The same with headings.
void posesFromThreeBearings(const ThreeBearingArrays<float>& problems, const PositionArrays<float>& positions,
                            const HeadingArrays<float>& headings);
void posesFromThreeBearings(const ThreeBearingArrays<double>& problems, const PositionArrays<double>& positions,
                            const HeadingArrays<double>& headings);
}  // namespace mrpt_ext
