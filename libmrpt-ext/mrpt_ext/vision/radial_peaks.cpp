#include "mrpt_ext/vision/radial_peaks.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kNeighbourhood = 1.3;  ///< a peak is the largest within this many standard deviations of the smoothing
constexpr double kFlank = 6;            ///< its flanks reach so many standard deviations
/// Neighbouring rows share pixels, and so do the rows of one pixel near the centre.
constexpr double kRowCorrelation = 1.2;
constexpr float kLeastEvidence = 1;
constexpr double kWiderSamples = 1.5;  ///< a peak so many times wider than its samples are apart is sampled again

std::optional<SampledPeak> gaussianAround(const RunProfile& profile, int column, int spacing)
{
  const double before = profile(column - spacing), here = profile(column), behind = profile(column + spacing);
  if (!(before > 0) || !(here > 0) || !(behind > 0)) return std::nullopt;
  const double a = std::log(before), b = std::log(here), c = std::log(behind), bend = a - 2 * b + c;
  if (!(bend < 0)) return std::nullopt;
  const double offset = 0.5 * (a - c) / bend;
  if (!(std::abs(offset) < 1)) return std::nullopt;
  return SampledPeak{offset * spacing, spacing / std::sqrt(-bend), static_cast<double>(spacing)};
}

double prominenceOf(const RunProfile& profile, int column, double peak, int reach)
{
  const auto lowest = [&](int direction)
  {
    double low = peak;
    for (int k = 1; k <= reach && low > 0; ++k) low = std::min(low, profile(column + direction * k));
    return std::max(low, 0.0);
  };
  return 1 - std::max(lowest(-1), lowest(1)) / peak;
}

/// Columns where the evidence is largest among their neighbours.
std::vector<int> peakColumns(const std::vector<RadialRun>& runs, int reach)
{
  const int columns = static_cast<int>(runs.size());
  const auto evidence = [&](int j) { return runs[static_cast<std::size_t>(wrappedColumn(j, columns))].evidence; };
  std::vector<int> peaks;
  for (int j = 0; j < columns; ++j)
  {
    bool is_peak = evidence(j) > kLeastEvidence;
    for (int k = 1; k <= reach && is_peak; ++k)
      is_peak = evidence(j) > evidence(j - k) && evidence(j) >= evidence(j + k);
    if (is_peak) peaks.push_back(j);
  }
  return peaks;
}
}  // namespace

RunProfile::RunProfile(const AzimuthSteps& steps, const RadialRun& run, int polarity, int middle, int reach)
    : first_(middle - reach), values_(static_cast<std::size_t>(2 * reach + 1), 0.0)
{
  const int columns = steps.heights.cols;
  double total = 0;
  for (int row = run.first; row < run.end; ++row)
  {
    const double weight = 1 / square(steps.noise[static_cast<std::size_t>(row)]);
    const float* const heights = steps.heights.ptr<float>(row);
    int j = wrappedColumn(first_, columns);
    for (double& value : values_)
    {
      value += weight * heights[j];
      if (++j == columns) j = 0;
    }
    total += weight;
  }
  for (double& value : values_) value *= polarity / total;
  noise_ = kRowCorrelation / std::sqrt(total);
}

double RunProfile::operator()(int column) const
{
  const int at = column - first_;
  return at >= 0 && at < static_cast<int>(values_.size()) ? values_[static_cast<std::size_t>(at)] : 0;
}

int RunProfile::reachOf(double sigma) { return static_cast<int>(std::ceil(3 * sigma)); }

RunProfile RunProfile::smoothed(double sigma) const
{
  const int reach = reachOf(sigma);
  std::vector<double> kernel;
  double total = 0;
  for (int k = -reach; k <= reach; ++k) total += kernel.emplace_back(std::exp(-square(k / sigma) / 2));
  RunProfile result = *this;
  result.first_ += reach;
  result.values_.resize(values_.size() - 2 * static_cast<std::size_t>(reach));
  for (std::size_t i = 0; i < result.values_.size(); ++i)
  {
    double sum = 0;
    for (std::size_t k = 0; k < kernel.size(); ++k) sum += kernel[k] * values_[i + k];
    result.values_[i] = sum / total;
  }
  return result;
}

std::optional<SampledPeak> sampledPeak(const RunProfile& profile, int column, int spacing)
{
  const auto near = gaussianAround(profile, column, spacing);
  if (!near || near->sigma < kWiderSamples * spacing) return near;
  return gaussianAround(profile, column,
                        static_cast<int>(std::lround(std::min<double>(near->sigma, reachOfSamples(spacing)))));
}

std::vector<RadialPeak> findRadialPeaks(const AzimuthSteps& steps, int polarity, double smoothing, double least_rows)
{
  const int spacing = std::max(1, static_cast<int>(std::lround(smoothing)));
  const auto runs = strongestRuns(steps, polarity);
  const int flank = static_cast<int>(kFlank * smoothing), reach = std::max(flank, reachOfSamples(spacing));
  std::vector<RadialPeak> peaks;
  for (const int column : peakColumns(runs, static_cast<int>(std::ceil(kNeighbourhood * smoothing))))
  {
    const RadialRun& run = runs[static_cast<std::size_t>(column)];
    if (run.end - run.first < least_rows) continue;
    const RunProfile profile(steps, run, polarity, column, reach);
    const auto peak = sampledPeak(profile, column, spacing);
    const double height = profile(column);
    if (!(height > 0)) continue;
    // Two edges may have no top between them.
    const SampledPeak shape = peak.value_or(SampledPeak{0, 1.0 * reach, 1.0 * spacing});
    peaks.push_back({run, polarity, column + shape.offset, shape.sigma, shape.spacing, height, profile.noise(),
                     prominenceOf(profile, column, height, flank)});
  }
  return peaks;
}

double columnNoise(const RadialPeak& peak, double smoothing)
{
  const double between = square(2 * peak.spacing / smoothing);
  const double correlation = (1 - between / 2) * std::exp(-between / 4);
  const double lower = std::exp(square(peak.spacing / peak.sigma) / 2);  // than the peak are the outer samples
  return square(peak.sigma) / peak.spacing * std::sqrt((1 - correlation) / 2) * lower / peak.significance();
}
}  // namespace mrpt_ext
