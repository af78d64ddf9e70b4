#include "mrpt_ext/correspondence/unsearched_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinDetection = 1e-9;

/// Product of two polynomials given by the logarithms of their coefficients.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> result(a.size() + b.size() - 1, kLogZero);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = logSum(result[i + j], a[i] + b[j]);
  return result;
}

double areaOf(const Box2& area) { return (area.max - area.min).cwiseMax(0.01).prod(); }

/// Density of a detection as one of a landmark in view, and as clutter.
struct Densities
{
  double of_landmark, of_clutter;
};

Densities densities(const LandmarkIndex& map, const SensorModel& model, const AnonymousDetection& z, double radius)
{
  Densities result{1, 1 / map.measurementVolume(z, model)};
  if (z.bearing) result.of_landmark = 1 / (model.has_field_of_view ? model.field_of_view : kTwoPi);
  // Landmarks fill the disk evenly, clutter is taken to fill the ranges evenly (pose_verification.h).
  if (z.range) result.of_landmark *= 2 * std::max(*z.range, z.std_range) / square(radius);
  if (z.category != kAnyCategory)
    result.of_landmark *=
        z.category == kUnknownCategory ? 0 : 1 / std::max(1.0, static_cast<double>(map.categoriesPresent()));
  return result;
}

/// Log of the expected likelihood of a scan's detections by the number that is matched, at a wrong pose.
std::vector<double> logLikelihoodByMatches(const LandmarkIndex& map, const Scan& scan)
{
  const SensorModel& model = scan.model;
  const double extent = areaOf({map.low(), map.high()});
  const double radius = model.max_range.value_or(std::sqrt(extent / kPi));
  const double clutter = boundedClutter(model.clutter_probability);
  const double expected_false = expectedFalseDetections(map, scan);
  std::vector<double> by_matches{0};
  for (const AnonymousDetection& z : scan.detections)
  {
    const Densities d = densities(map, model, z, radius);
    const double right = model.detection_probability ? 1 : 1 - clutter;
    const double wrong = model.detection_probability ? expected_false : clutter;
    by_matches = product(by_matches, {std::log(wrong * d.of_clutter), std::log(right * d.of_landmark)});
  }
  if (!model.detection_probability) return by_matches;

  const double p = std::clamp(*model.detection_probability, kMinDetection, kMaxDetectionProbability);
  const double in_view = shareInView(map, model);
  const auto n = static_cast<double>(map.size());
  for (std::size_t m = 0; m < by_matches.size(); ++m)
  {
    const auto matched = static_cast<double>(m);
    by_matches[m] += matched > n ? kLogZero
                                 : std::lgamma(n + 1) - std::lgamma(n - matched + 1) + matched * std::log(p * in_view) +
                                       (n - matched) * std::log1p(-p * in_view);
  }
  return by_matches;
}
}  // namespace

double shareInView(const LandmarkIndex& map, const SensorModel& model)
{
  const double extent = areaOf({map.low(), map.high()});
  const double share = model.max_range ? std::min(1.0, kPi * square(*model.max_range) / extent) : 1.0;
  return model.has_field_of_view ? share * std::min(1.0, model.field_of_view / kTwoPi) : share;
}

double expectedFalseDetections(const LandmarkIndex& map, const Scan& scan)
{
  const SensorModel& model = scan.model;
  const double clutter = boundedClutter(model.clutter_probability);
  if (!model.detection_probability) return clutter * static_cast<double>(scan.detections.size());
  const double p = std::clamp(*model.detection_probability, kMinDetection, kMaxDetectionProbability);
  return clutter / (1 - clutter) * p * shareInView(map, model) * static_cast<double>(map.size());
}

Box2 areaOrMap(const LandmarkIndex& map, const std::optional<Box2>& area)
{
  return area ? *area : Box2{map.low(), map.high()};
}

std::vector<double> logEvidenceOfUnsearched(const LandmarkIndex& map, std::span<const Scan> scans, const Box2& area)
{
  std::vector<double> by_matches{0};
  for (const Scan& scan : scans) by_matches = product(by_matches, logLikelihoodByMatches(map, scan));
  const double log_volume = std::log(kTwoPi * areaOf(area));
  std::vector<double> below{kLogZero};
  for (const double log_likelihood : by_matches) below.push_back(logSum(below.back(), log_likelihood + log_volume));
  if (map.empty()) std::fill(below.begin(), below.end(), kLogZero);
  return below;
}

double logEvidenceOfUnsearched(const LandmarkIndex& map, std::span<const Scan> scans, const Box2& area, int least)
{
  const std::vector<double> below = logEvidenceOfUnsearched(map, scans, area);
  return below[std::min(static_cast<std::size_t>(std::max(least, 0)), below.size() - 1)];
}
}  // namespace mrpt_ext
