#pragma once

namespace mrpt_ext
{
/// What chance has to work with when poses are sought for bearings that do not belong to them.
struct BearingFalseAlarmModel
{
  double poses_per_triple = 0;  ///< constellations of three landmarks that give a possible pose, per triple of bearings
  int bearings = 0;
  double chance = 0;  ///< that a landmark lies within the gate of a reading at a wrong pose
};

/// Expected number of wrong poses that explain at least `matched` of the bearings: with T possible poses per triple,
///   E = T C(K, 3) / C(m, 3) G_m P(at least m - 3 of K - 3 hit by chance),   G_3 = 1, G_m = 1.9 sqrt(C(m, 3)).
/// The binomial tail stands for p^(K - 3) when bearings may stay unexplained; C(K, 3) / C(m, 3) counts the poses that a
/// given triple cannot propose because one of its bearings is unexplained. G_m is what the freedom of the pose adds, as
/// the gates need to hold at some pose and not at that of one triple: the bearings that m landmarks give form a surface
/// of three dimensions, whose area is the root of the sum of the squares of what its C(m, 3) triples see of it
/// (Cauchy-Binet); 1.9 is measured. Agrees with counted poses within a factor of two.
[[nodiscard]] double expectedFalsePoses(const BearingFalseAlarmModel& chance, int matched);

/// Chance that a reading has a landmark within +-`gate` [rad], with `in_view` landmarks that it may show spread over
/// all directions.
[[nodiscard]] double chanceMatchProbability(double gate, double in_view);
}  // namespace mrpt_ext
