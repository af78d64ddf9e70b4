#pragma once

#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/filter/particles/simd_random.h"

namespace mrpt_ext
{
/// One motion with its noise, in single precision. With a, b, c standard normal, the increment of a particle is
/// (x + xa a + swing_x t, y + ya a + yb b + swing_y t, turn + t), t = std_turn c.
struct MotionStep
{
  float x = 0, y = 0, turn = 0;    ///< [m, m, rad] in the robot frame
  float xa = 0, ya = 0, yb = 0;    ///< [m]
  float swing_x = 0, swing_y = 0;  ///< [m per rad]
  float std_turn = 0;              ///< [rad]
};

/// What an error of a particle of one unit adds to its motion: a turn, and what the end moves by beside half of that
/// turn of the chord. All zero for the error of the distance, which is a factor, and those of sensors.
struct BiasLever
{
  float turn = 0;      ///< [rad]
  float x = 0, y = 0;  ///< [m]
};

/// Moves `count` particles from `first` on; `levers` in the order of their errors.
void moveBlock(ParticleSet& particles, const MotionStep& step, const std::vector<BiasLever>& levers, std::size_t first,
               std::size_t count, SimdRandom& random);
}  // namespace mrpt_ext
