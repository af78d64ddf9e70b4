#pragma once

#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// One motion, then another: increment, path and its moments (path_moments.h), and the covariance of what exceeds the
/// stated noise. Where an error of the heading arises in the first part, it also turns the second one.
[[nodiscard]] inline OdometryMotion concatenated(const OdometryMotion& first, const OdometryMotion& second)
{
  const Matrix3d by_first = composeJacobianFirst(first.increment, second.increment),
                 by_second = composeJacobianSecond(first.increment);
  const PathMoments before = momentsOf(first), after = momentsOf(second);
  PathMoments moments;
  for (const auto sum : {&PathMoments::by_turn, &PathMoments::by_arc, &PathMoments::by_length, &PathMoments::by_time})
    moments.*sum = by_first * (before.*sum) + by_second * (after.*sum);
  for (const auto sum : {&PathMoments::turned, &PathMoments::length, &PathMoments::time})
    moments.*sum = by_first * (before.*sum) * by_first.transpose() + by_second * (after.*sum) * by_second.transpose();
  moments.along_arcs = before.along_arcs + rotation(first.increment.phi) * after.along_arcs;
  return {.increment = compose(first.increment, second.increment),
          .path_length = first.path_length + second.path_length,
          .turned = first.turned + second.turned,
          .duration = first.duration + second.duration,
          .excess = by_first * first.excess * by_first.transpose() + by_second * second.excess * by_second.transpose(),
          .moments = moments};
}
}  // namespace mrpt_ext
