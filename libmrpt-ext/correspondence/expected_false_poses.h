#pragma once

namespace mrpt_ext
{
/// What chance has to work with when poses are sought for readings that do not belong to them.
struct ChanceMatches
{
  double poses_per_triple = 0;  ///< constellations of three landmarks that give a possible pose, per triple of readings
  int readings = 0;
  double chance = 0;  ///< that a landmark lies within the gate of a reading at a wrong pose
};

/// Expected number of wrong poses that explain at least `matched` of the readings: with T possible poses per triple,
///   E = T C(K, 3) / C(m, 3) (m / 3)^(3/2) P(at least m - 3 of K - 3 hit by chance).
/// The binomial tail stands for p^(K - 3) when readings may stay unexplained; C(K, 3) / C(m, 3) counts the poses that a
/// given triple cannot propose because one of its readings is unexplained; (m / 3)^(3/2) is what the gates gain because
/// the pose is free to move to where all its matches fit (equations of chance matches alone are 1.5 to 4 times too
/// low at 12 landmarks).
[[nodiscard]] double expectedFalsePoses(const ChanceMatches& chance, int matched);

/// Chance that a reading has a landmark within +-`gate` [rad], with `in_view` landmarks that it may show spread over
/// all directions.
[[nodiscard]] double chanceOfMatch(double gate, double in_view);
}  // namespace mrpt_ext
