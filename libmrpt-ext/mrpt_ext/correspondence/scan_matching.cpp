#include "mrpt_ext/correspondence/scan_matching.h"

#include <algorithm>

#include "mrpt_ext/correspondence/unsearched_evidence.h"
#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kCostOfPrediction = 200, kCostOfPair = 8;  // operations
constexpr double kSlack = 3;  // standard deviations of the pose by which a landmark may be out of view

double quadratic(const JacobianRow& J, const Matrix3d& P) { return std::max(0.0, (J * P * J.transpose()).value()); }

/// Squared residual in standard deviations, or nothing beyond the gate.
std::optional<double> distance2(const AnonymousDetection& z, const ExpectedLandmark& h, double gate)
{
  double sum = 0;
  const auto within = [&](double residual, double variance)
  {
    const double e2 = residual * residual / variance;
    sum += e2;
    return e2 <= gate * gate;
  };
  if (z.bearing && !within(wrap(*z.bearing - h.bearing), square(z.std_bearing) + h.bearing_variance))
    return std::nullopt;
  if (z.range && !within(*z.range - h.range, square(z.std_range) + h.range_variance)) return std::nullopt;
  return sum;
}

double density(const AnonymousDetection& z, const ExpectedLandmark& h)
{
  double log_density = 0;
  if (z.bearing) log_density += logNormal(wrap(*z.bearing - h.bearing), square(z.std_bearing));
  if (z.range) log_density += logNormal(*z.range - h.range, square(z.std_range));
  return std::exp(log_density);
}

/// Probability of a value below `limit`.
double probabilityBelow(double limit, double mean, double variance)
{
  return 0.5 * std::erfc((mean - limit) / std::sqrt(2 * std::max(variance, 1e-18)));
}

double visibilityOf(const SensorModel& model, const ExpectedLandmark& h)
{
  double probability = model.max_range ? probabilityBelow(*model.max_range, h.range, h.range_variance) : 1;
  if (model.has_field_of_view)
    probability *= probabilityBelow(0.5 * model.field_of_view, std::abs(h.bearing), h.bearing_variance);
  return probability;
}
}  // namespace

std::uint64_t costOfMatching(std::size_t expected, std::size_t detections)
{
  return expected * (kCostOfPrediction + kCostOfPair * detections);
}

std::uint64_t costOfMatching(const LandmarkIndex& map, const Scan& scan)
{
  const Vector2d extent = map.high() - map.low();
  const double area = std::max(extent.prod(), 1e-3 * extent.squaredNorm() + 1e-9);
  const double seen = scan.model.max_range ? std::min(1.0, kPi * square(*scan.model.max_range) / area) : 1;
  return costOfMatching(static_cast<std::size_t>(seen * static_cast<double>(map.size())), scan.detections.size());
}

std::vector<ExpectedLandmark> expectedLandmarks(const LandmarkIndex& map, const Scan& scan, const GaussianPose& robot)
{
  const Pose2 sensor = compose(robot.mean, scan.T_robot_sensor);
  const Vector2d offset = scan.T_robot_sensor.position();
  const double position_std = std::sqrt(robot.covariance.topLeftCorner<2, 2>().trace());
  const double farthest = map.empty()            ? 0
                          : scan.model.max_range ? *scan.model.max_range + kSlack * position_std
                                                 : map.farthestFrom(sensor.position());
  std::vector<ExpectedLandmark> expected;
  map.forEachNear(sensor.position(), farthest,
                  [&](std::size_t landmark)
                  {
                    const Vector2d& position = map.position(landmark);
                    const Vector2d d = position - sensor.position();
                    ExpectedLandmark h{.landmark = landmark, .range = d.norm()};
                    if (!(h.range > 0)) return;
                    h.bearing = wrap(std::atan2(d.y(), d.x()) - sensor.phi);
                    h.bearing_variance = quadratic(bearingJacobian(robot.mean, position, offset), robot.covariance);
                    h.range_variance = quadratic(rangeJacobian(robot.mean, position, offset), robot.covariance);
                    const bool near = !scan.model.max_range || h.range <= *scan.model.max_range;
                    h.in_view = near && std::abs(h.bearing) <= 0.5 * scan.model.field_of_view;
                    h.visibility = visibilityOf(scan.model, h);
                    expected.push_back(h);
                  });
  WorkCounter::add(kCostOfPrediction * expected.size());
  return expected;
}

std::vector<int> associate(const LandmarkIndex& map, const Scan& scan, std::span<const ExpectedLandmark> expected,
                           double gate)
{
  struct Pair
  {
    double distance2;
    int detection, expected;
  };
  std::vector<Pair> pairs;
  WorkCounter::add(kCostOfPair * expected.size() * scan.detections.size());
  for (std::size_t d = 0; d < scan.detections.size(); ++d)
    for (std::size_t h = 0; h < expected.size(); ++h)
      if (map.mayShow(scan.detections[d].category, expected[h].landmark))
        if (const auto e2 = distance2(scan.detections[d], expected[h], gate))
          pairs.push_back({*e2, static_cast<int>(d), static_cast<int>(h)});
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance2 < b.distance2; });
  std::vector<int> matches(scan.detections.size(), -1);
  std::vector<bool> taken(expected.size(), false);
  for (const Pair& pair : pairs)
  {
    int& match = matches[static_cast<std::size_t>(pair.detection)];
    if (match >= 0 || taken[static_cast<std::size_t>(pair.expected)]) continue;
    match = pair.expected;
    taken[static_cast<std::size_t>(pair.expected)] = true;
  }
  return matches;
}

double scanLogLikelihood(const LandmarkIndex& map, const Scan& scan, std::span<const ExpectedLandmark> expected,
                         std::span<const int> matches)
{
  std::vector<int> claimed_by(expected.size(), -1);
  for (std::size_t d = 0; d < matches.size(); ++d)
    if (matches[d] >= 0) claimed_by[static_cast<std::size_t>(matches[d])] = static_cast<int>(d);

  const SensorModel& model = scan.model;
  const double clutter = boundedClutter(model.clutter_probability);
  const bool counts_missed = model.detection_probability.has_value();
  const double p = std::clamp(model.detection_probability.value_or(0), 0.0, kMaxDetectionProbability);
  const double expected_false = expectedFalseDetections(map, scan);
  double log_likelihood = 0;
  std::vector<double> weight;  // of a landmark as the source of a detection
  for (const ExpectedLandmark& h : expected)
  {
    weight.push_back(counts_missed ? p * h.visibility / (1 - p * h.visibility) : h.visibility);
    if (counts_missed) log_likelihood += std::log1p(-p * h.visibility);
  }
  for (std::size_t d = 0; d < scan.detections.size(); ++d)
  {
    const AnonymousDetection& z = scan.detections[d];
    double sum = 0, visible = 0;
    for (std::size_t h = 0; h < expected.size(); ++h)
    {
      if (!map.mayShow(z.category, expected[h].landmark)) continue;
      visible += expected[h].visibility;
      if (weight[h] > 0 && (claimed_by[h] < 0 || claimed_by[h] == static_cast<int>(d)))
        sum += weight[h] * density(z, expected[h]);
    }
    const double false_density = 1 / map.measurementVolume(z, model);
    log_likelihood += counts_missed ? std::log(expected_false * false_density + sum)
                                    : std::log(clutter * false_density + (1 - clutter) * sum / std::max(1.0, visible));
  }
  return log_likelihood;
}
}  // namespace mrpt_ext
