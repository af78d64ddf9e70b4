#include "mrpt_ext/filter/kalman/kalman_association.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/likelihood/visibility_limits.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kCostOfFar = 60, kCostOfLinearisation = 400;  // operations, of a landmark
constexpr double kFar = 12;  // standard deviations: the density there is below e^-72 of its peak

/// Leaves out landmarks whose linearisation would be wasted: far out of range, or far from the detection.
class FarLandmarks
{
 public:
  FarLandmarks(const Detection& detection, const Reading& reading, const KalmanState& state, const BiasModel& biases)
      : detection_(detection), reading_(reading), robot_(state.pose()), unbiased_(biases.empty())
  {
    const VisibilityLimits limits(reading.model);
    if (limits.range_slope > 0) farthest_ = limits.range_offset / limits.range_slope;
    sensor_ = compose(robot_, reading.T_robot_sensor).position();
    std_heading_ = std::sqrt(state.covariance(2, 2));
    std_position_ = std::sqrt(state.covariance(0, 0) + state.covariance(1, 1)) +
                    std_heading_ * reading.T_robot_sensor.position().norm();
  }

  /// The visibility of such a landmark; nothing for one that may matter.
  [[nodiscard]] std::optional<double> visibilityIfFar(const Landmark& landmark) const
  {
    const double distance = (landmark.position.head<2>() - sensor_).norm();
    if (distance > farthest_) return 0;
    if (!unbiased_) return std::nullopt;
    const LandmarkPrediction prediction = predict(landmark, reading_, robot_);
    const double std_direction = std_heading_ + std_position_ / std::max(distance, 1e-6);
    const auto is_far = [](double residual, double variance, double std_of_state)
    { return std::abs(residual) > kFar * (std::sqrt(variance) + std_of_state); };
    const bool far =
        (detection_.bearing && is_far(wrap(*detection_.bearing - prediction.bearing),
                                      square(detection_.std_bearing) + prediction.bearing_variance, std_direction)) ||
        (detection_.range && is_far(*detection_.range - prediction.range,
                                    square(detection_.std_range) + prediction.range_variance, std_position_));
    return far ? std::optional(prediction.visibility) : std::nullopt;
  }

 private:
  const Detection& detection_;
  const Reading& reading_;
  Pose2 robot_;
  bool unbiased_;
  double farthest_ = std::numeric_limits<double>::infinity();
  Vector2d sensor_{0, 0};
  double std_heading_ = 0, std_position_ = 0;
};
}  // namespace

Association associate(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                      const KalmanState& state, const BiasModel& biases, double default_max_range)
{
  const double clutter = std::clamp(reading.model.clutter_probability, kMinClutterProbability, 1.0);
  const bool identified = detection.id != kNoId;
  Association result;
  double view_sum = 0, likelihood_sum = 0, best = 0;
  const auto consider = [&](std::size_t j)
  {
    WorkCounter::add(kCostOfLinearisation);
    const DetectionRows rows = linearise(detection, reading, map[j], state.mean, biases);
    const double in_view = identified ? 1.0 : rows.visibility;  // what is identified was in view
    if (!(in_view > 0)) return;
    const Innovation innovation = innovationOf(rowsOf(rows), state.covariance);
    const double likelihood = in_view * std::exp(innovation.log_density);
    view_sum += in_view;
    likelihood_sum += likelihood;
    if (!(likelihood > best)) return;
    best = likelihood;
    result.nis = innovation.nis;
    result.landmark = j;
    result.rows = rows;
  };
  if (identified)
  {
    if (const auto known = map.indexOf(detection.id)) consider(*known);
  }
  else
  {
    const FarLandmarks far(detection, reading, state, biases);
    WorkCounter::add(kCostOfFar * map.size());
    for (std::size_t j = 0; j < map.size(); ++j)
    {
      if (!mayShow(detection, map[j])) continue;
      if (const auto visibility = far.visibilityIfFar(map[j]))
        view_sum += *visibility;
      else
        consider(j);
    }
  }

  const double scale = view_sum > 0 ? (1 - clutter) / view_sum : 0;
  const double from_clutter =
      (view_sum > 0 ? clutter : 1.0) / measurementVolume(detection, reading.model, default_max_range);
  result.evidence = scale * likelihood_sum + from_clutter;
  result.inlier_probability = scale * likelihood_sum / result.evidence;
  result.best = scale * best / result.evidence;
  return result;
}
}  // namespace mrpt_ext
