#pragma once

#include <vector>

#include "mrpt_ext/correspondence/bearings/triple_scan.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Three bearings in the form in which the pose of a hit depends on them.
struct TripleBearings
{
  float middle_x = 1, middle_y = 0;                     ///< unit vector of the middle bearing, sensor's axes
  float std_middle = 0, std_first = 0, std_second = 0;  ///< [rad]
};

/// Sensor poses of the hits of one triple scan with their uncertainty, as arrays.
struct TriplePoses
{
  std::vector<float> x, y;  ///< [m] relative to landmark i
  std::vector<float> c, s;  ///< cosine and sine of the heading
  /// What one standard deviation of each bearing does to the pose [m, m, rad]: the covariance is the sum of their
  /// squares. Kept as factors, because a covariance in float would lose the small variances of a weakly fixed pose.
  std::vector<float> ix, iy, ih, jx, jy, jh, kx, ky, kh;
  std::size_t count = 0;

  void resize(std::size_t size);
};

/// Exact heading and first-order uncertainty of every hit: the rows of the Jacobian are (e, -1) with e = (dy, -dx) /
/// d^2, so that differences of two rows leave a 2x2 system for the position.
void posesOfHits(const TripleBearings& bearings, const Neighbours& first, const Neighbours& second,
                 const TripleHits& hits, TriplePoses& poses);
}  // namespace mrpt_ext
