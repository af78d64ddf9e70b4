#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/vision/radial_votes.h"

namespace mrpt_ext
{
/// Steps of one run of rows summed with the weights 1/noise^2, as a function of the column, about one of them.
class RunProfile
{
 public:
  /// At the columns up to `reach` beside `middle`, also across the seam.
  RunProfile(const AzimuthSteps& steps, const RadialRun& run, int polarity, int middle, int reach);

  /// [grey levels] mean step at a column, positive for the polarity's edges; 0 beyond the reach.
  [[nodiscard]] double operator()(int column) const;
  /// [grey levels] standard deviation of a value.
  [[nodiscard]] double noise() const { return noise_; }
  /// Smoothed again, by a Gaussian of so many columns. Its reach is smaller by that of the Gaussian.
  [[nodiscard]] RunProfile smoothed(double sigma) const;
  /// [columns] by which smoothing takes from the reach.
  [[nodiscard]] static int reachOf(double sigma);

 private:
  int first_ = 0;
  std::vector<double> values_;
  double noise_ = 0;
};

/// A Gaussian through three samples of a profile.
struct SampledPeak
{
  double offset = 0;   ///< [columns] from the middle sample
  double sigma = 0;    ///< [columns]
  double spacing = 0;  ///< [columns] of the samples
};

/// Through samples about as far apart as the peak is wide, beginning with `spacing` columns: near its top a wide peak
/// is flat. Nothing where there is no peak.
[[nodiscard]] std::optional<SampledPeak> sampledPeak(const RunProfile& profile, int column, int spacing);

/// [columns] beside the middle one that `sampledPeak` may look at.
[[nodiscard]] inline int reachOfSamples(int spacing) { return 4 * spacing; }

/// A peak of the evidence for edges of one polarity, before anybody judges whether it is an edge. Lengths are columns.
struct RadialPeak
{
  RadialRun run;
  int polarity = 0;
  double column = 0;      ///< where the profile of the run is highest, from a Gaussian through three samples
  double sigma = 0;       ///< of that Gaussian; as wide as is looked where there is no top
  double spacing = 0;     ///< of its samples
  double height = 0;      ///< [grey levels]
  double noise = 0;       ///< [grey levels] of the profile
  double prominence = 0;  ///< how far the profile falls on the side that falls less, share of the height

  [[nodiscard]] double significance() const { return height / noise; }
};

/// All peaks of one polarity whose run has at least `least_rows` rows, for steps smoothed by `smoothing` columns.
[[nodiscard]] std::vector<RadialPeak> findRadialPeaks(const AzimuthSteps& steps, int polarity, double smoothing,
                                                      double least_rows);

/// Standard deviation of a peak's column by noise, for steps smoothed by `smoothing` columns: that of the difference of
/// the logarithms of the outer samples, over the bend of the Gaussian. White noise through a Gaussian's derivative has
/// the autocorrelation (1 - d^2 / 2 s^2) exp(-d^2 / 4 s^2) at the distance d.
[[nodiscard]] double columnNoise(const RadialPeak& peak, double smoothing);
}  // namespace mrpt_ext
