#include "mrpt_ext/frames/reflector_extraction.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostDarkBeams = 1;  ///< within a reflector
constexpr double kGate = 3;                ///< standard deviations between the ranges of two beams on one reflector
/// Beams beyond the edges of a reflector that may still meet it: they are about as wide as their spacing.
constexpr double kBeamsAtEdges = 2;

/// Beams that lie on one surface, by their numbers; beyond the last one of a full turn they go on counting.
using Cluster = std::vector<std::size_t>;

class Extraction
{
 public:
  Extraction(const RangeScan& scan, const ReflectorOptions& options)
      : scan_(scan), options_(options), spacing_(std::abs(scan.bearing_step))
  {
  }

  Reflectors run() const
  {
    Reflectors found;
    for (const Cluster& cluster : clusters())
    {
      if (isTooWide(cluster))
        ++found.too_wide;
      else
        found.detections.push_back(detectionOf(cluster));
    }
    return found;
  }

 private:
  [[nodiscard]] std::size_t size() const { return scan_.ranges.size(); }
  [[nodiscard]] double range(std::size_t beam) const { return scan_.ranges[beam % size()]; }
  [[nodiscard]] bool isBright(std::size_t beam) const
  {
    return scan_.intensities[beam % size()] > options_.intensity_above && range(beam) > 0;
  }

  /// A beam from which one turn meets every reflector as a whole: where the scan goes all around, one that is dark with
  /// its neighbours; else the first one.
  [[nodiscard]] std::size_t firstBeam() const
  {
    if (spacing_ * (static_cast<double>(size()) + 0.5) < kTwoPi) return 0;
    std::size_t dark = 0;
    for (std::size_t beam = 0; beam < size(); ++beam)
    {
      dark = isBright(beam) ? 0 : dark + 1;
      if (dark > kMostDarkBeams) return beam;
    }
    return 0;
  }

  [[nodiscard]] std::vector<Cluster> clusters() const
  {
    std::vector<Cluster> clusters;
    const std::size_t first = firstBeam();
    for (std::size_t beam = first; beam < first + size(); ++beam)
    {
      if (!isBright(beam)) continue;
      if (clusters.empty() || !isNext(clusters.back().back(), beam)) clusters.emplace_back();
      clusters.back().push_back(beam);
    }
    return clusters;
  }

  /// Whether two bright beams lie on one surface.
  [[nodiscard]] bool isNext(std::size_t before, std::size_t beam) const
  {
    if (beam - before > kMostDarkBeams + 1) return false;
    const double apart = range(before) * spacing_ * static_cast<double>(beam - before);
    const double depth = std::max(options_.diameter, apart) + kGate * std::sqrt(2.0) * scan_.std_range;
    return std::abs(range(before) - range(beam)) <= depth;
  }

  [[nodiscard]] double medianRange(const Cluster& cluster) const
  {
    std::vector<double> ranges;
    for (const std::size_t beam : cluster) ranges.push_back(range(beam));
    return upperMedian(std::move(ranges));
  }

  [[nodiscard]] bool isTooWide(const Cluster& cluster) const
  {
    if (options_.diameter <= 0) return false;
    const double spacing = medianRange(cluster) * spacing_;
    const double width = spacing * static_cast<double>(cluster.back() - cluster.front());
    return width > options_.diameter + kBeamsAtEdges * spacing;
  }

  [[nodiscard]] Detection detectionOf(const Cluster& cluster) const
  {
    const double first = mrpt_ext::bearingOf(scan_, cluster.front()), last = mrpt_ext::bearingOf(scan_, cluster.back());
    const double centre = 0.5 * (first + last);
    std::vector<double> ranges;
    for (const std::size_t beam : cluster)
      ranges.push_back(rangeToCentre(range(beam), mrpt_ext::bearingOf(scan_, beam) - centre));
    return {.id = kNoId,
            .category = {},
            .bearing = wrap(centre),
            .range = upperMedian(std::move(ranges)),
            .std_bearing = spacing_ / std::sqrt(cluster.size() == 1 ? 12.0 : 24.0),
            .std_range = scan_.std_range};
  }

  /// Range to the centre when a beam that is `off` its bearing [rad] meets the surface at this range.
  [[nodiscard]] double rangeToCentre(double range, double off) const
  {
    const double along = range * std::cos(off), across = range * std::sin(off);
    if (options_.shape == ReflectorShape::flat) return along;
    return along + std::sqrt(std::max(0.0, square(0.5 * options_.diameter) - square(across)));
  }

  const RangeScan& scan_;
  const ReflectorOptions& options_;
  double spacing_;  // [rad]
};
}  // namespace

Reflectors extractReflectors(const RangeScan& scan, const ReflectorOptions& options)
{
  if (scan.ranges.empty() || scan.intensities.size() != scan.ranges.size()) return {};
  return Extraction(scan, options).run();
}

Reading reflectorReading(const RangeScan& scan, Reflectors reflectors)
{
  Reading reading;
  reading.time = scan.time;
  reading.sensor = scan.sensor;
  reading.T_robot_sensor = scan.T_robot_sensor;
  reading.sensor_height = scan.sensor_height;
  reading.horizontal_range = true;  // it is measured in the plane of the scan
  reading.detections = std::move(reflectors.detections);
  const double spacing = std::abs(scan.bearing_step);
  const std::size_t beams = scan.ranges.size();
  const bool symmetric = beams > 0 && std::abs(scan.first_bearing + bearingOf(scan, beams - 1)) < spacing;
  reading.model.has_field_of_view = symmetric;
  if (symmetric) reading.model.field_of_view = std::min(kTwoPi, spacing * static_cast<double>(beams));
  return reading;
}
}  // namespace mrpt_ext
