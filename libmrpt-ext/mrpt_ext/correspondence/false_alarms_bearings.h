#pragma once

namespace mrpt_ext
{
/// Statistics of poses that bearings support by chance.
struct BearingFalseAlarmModel
{
  double poses_per_triple = 0;  ///< possible poses from landmark triples, per triple of bearings
  int bearings = 0;
  double chance = 0;  ///< that a landmark is within the gate of a bearing at a wrong pose
};

/// Expected number of wrong poses with at least `matched` inliers: with T possible poses per triple and K bearings,
///   E = T C(K, 3) / C(m, 3) G_m P(at least m - 3 of K - 3 match by chance),   G_3 = 1, G_m = 1.9 sqrt(C(m, 3)).
/// The binomial tail replaces p^(K - 3) where bearings may be outliers. C(K, 3) / C(m, 3) counts the poses that a
/// given triple cannot propose because one of its bearings is an outlier. G_m accounts for the free pose: the gates
/// need to hold at some pose, not at that of one triple. The bearings to m landmarks form a surface of three
/// dimensions whose area is the root of the sum of the squares of its C(m, 3) projections (Cauchy-Binet); 1.9 is
/// measured. Agrees with counted poses within a factor of two.
[[nodiscard]] double expectedFalsePoses(const BearingFalseAlarmModel& chance, int matched);

/// Probability that a bearing has a landmark within +-`gate` [rad], for `in_view` candidate landmarks spread over
/// all directions.
[[nodiscard]] double chanceMatchProbability(double gate, double in_view);
}  // namespace mrpt_ext
