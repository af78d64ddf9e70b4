#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/feature_mixture.h"
#include "mrpt_ext/filter/motion/dead_reckoning.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Null hypothesis of the pose test: what a robot without a map expects to measure. A static feature is seen again
/// where it was seen before, shifted by parallax.
///
/// A pose that fits an anonymous bearing once goes on to fit the same feature, right or wrong: the next bearing of it
/// is no evidence. So the likelihood of a pose (sequential_pose_test.h) is compared with this model, not with a
/// uniform density. Correlated bearings count for neither. They move the features that they show, as the particles
/// follow the robot's turns by them: with odometry alone in the meantime features would be lost, and any pose would
/// seem better. Each tracked feature is a direction in odometry's axes and a distribution over its range. A bearing
/// comes from one of the features in view, or from a new one, with the frequency of new features among the independent
/// bearings so far.
class NullModel
{
 public:
  /// `max_range` [m]: features farther away are treated as if they were at that range.
  NullModel(const MotionModel& motion, double max_range);

  void clear() { *this = NullModel(motion_, max_range_); }
  void move(const OdometryMotion& motion);
  /// The log density of the result is that of a bearing [1/rad], clutter included, given those before; the bearing is
  /// remembered. The detection has a bearing and no range.
  FeatureMixture::Outcome observe(const Reading& reading, const Detection& bearing);
  /// A bearing that is correlated with those before moves the feature that it shows, unless it rather shows something
  /// else. It does not count among those that tell how frequent new ones are, nor is it a new one.
  void track(const Reading& reading, const Detection& bearing);

  /// Number of tracked features.
  [[nodiscard]] std::size_t size() const { return features_.size(); }

 private:
  static constexpr std::size_t kRanges = 40;
  using RangeWeights = std::array<double, kRanges>;

  struct TrackedFeature
  {
    std::string sensor, category;
    std::array<Vector2d, kRanges> position;  ///< candidates in odometry's axes, nearest first
    RangeWeights weight;                     ///< of the candidates, sum 1
    double std_bearing = 0;                  ///< of the last bearing [rad]
    double heading_variance = 0;             ///< of odometry at the last bearing [rad^2]
  };
  /// A feature as the sensor would see it now.
  struct PredictedBearing
  {
    double in_view = 0;   ///< probability
    double density = 0;   ///< of the bearing [1/rad]
    RangeWeights weight;  ///< posterior of the candidates
  };

  /// A bearing compared with the features of its sensor and category.
  struct Match
  {
    Pose2 sensor;        ///< in odometry's axes
    double uniform = 0;  ///< density of the bearing if it shows something new
    FeatureDensities all;
    std::optional<std::size_t> best;  ///< index of the feature that fits best
    PredictedBearing prediction;      ///< of that one
  };

  [[nodiscard]] PredictedBearing predict(const TrackedFeature& feature, const Pose2& sensor, const SensorModel& model,
                                         const Detection& bearing) const;
  [[nodiscard]] Match match(const Reading& reading, const Detection& bearing) const;
  /// The best one was seen.
  void update(const Match& match, const Detection& bearing);
  /// The feature along the bearing, at these ranges.
  void relocate(TrackedFeature& feature, const Pose2& sensor, const Detection& bearing, const RangeWeights& ranges);
  void add(const Reading& reading, const Pose2& sensor, const Detection& bearing);

  MotionModel motion_;
  double max_range_;
  DeadReckoning odometry_;  // since the start
  FeatureMixture mixture_;
  std::vector<TrackedFeature> features_;  // the one seen last is the last one
};
}  // namespace mrpt_ext
