#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
/// Normalised estimation error squared, e^T P^-1 e, averaged over a run (Bar-Shalom, Li, Kirubarajan 2001, section
/// 5.4): about the number of degrees of freedom for a consistent covariance, larger for an overconfident one.
struct Consistency
{
  std::optional<double> mean;                 ///< over the judged estimates
  std::optional<double> band_low, band_high;  ///< 95 % of the means of as many *independent* estimates
  std::size_t count = 0;                      ///< estimates that entered
  std::size_t singular = 0;                   ///< left out: covariance not positive definite
};

/// Of one estimate.
struct NeesSample
{
  double stamp = 0;  ///< [s] the scoring stamp
  double value = 0;
  int degrees_of_freedom = 3;
  Matrix3d covariance = Matrix3d::Zero();  ///< that the error was measured by
};

/// Of every estimate whose covariance is positive definite.
[[nodiscard]] std::vector<NeesSample> neesOf(const std::vector<JudgedEstimate>& judged);

/// Three degrees of freedom per estimate, two where truth or estimate have no heading. The errors of neighbouring
/// estimates of a filter are correlated, so even a consistent filter leaves the band more often than in 5 % of runs.
[[nodiscard]] Consistency consistency(const std::vector<JudgedEstimate>& judged);

/// Share of the estimates whose truth lies in the region that their covariance gives this probability; absent without
/// one. An estimate with a singular covariance does not count.
[[nodiscard]] std::optional<double> coverage(const std::vector<JudgedEstimate>& judged, double probability);

/// Value that a chi-square variable stays below with this probability.
[[nodiscard]] double chiSquareQuantile(double degrees_of_freedom, double probability);
}  // namespace mrpt_ext
