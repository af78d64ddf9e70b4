#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/feature_mixture.h"
#include "mrpt_ext/filter/integrity/heading_and_directions.h"
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
/// seem better. Each tracked feature is a direction in odometry's axes and a distribution over its range. The drift of
/// odometry's heading is common to all of them (heading_and_directions.h), as a pose has one heading: without that, a
/// pose with two landmarks would know better than this model what is seen beside the first.
///
/// A bearing comes from one of the features in view, or from a new one, with the frequency of new features among the
/// independent bearings so far. Features that odometry has lost stay in view and are not seen any more. When a feature
/// is lost is not known, so its chance is that of an event that was missed m times since it last happened, 1 / (m + 2)
/// (Laplace's rule of succession).
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
  using Candidates = std::array<Vector2d, kRanges>;

  struct TrackedFeature
  {
    std::string sensor, category;
    Vector2d anchor;       ///< the sensor's position at the last bearing, in odometry's axes
    double direction = 0;  ///< from there, in odometry's axes
    RangeWeights range;    ///< candidates, nearest first
    RangeWeights weight;   ///< of the candidates, sum 1
    std::size_t seen = 0;  ///< number of the last bearing
    double missed = 0;     ///< expected number of independent bearings since the last one, while it was in view
  };
  /// A feature as the sensor would see it now.
  struct PredictedBearing
  {
    double in_view = 0;     ///< probability
    double density = 0;     ///< of the bearing [1/rad]
    RangeWeights weight;    ///< posterior of the candidates
    double innovation = 0;  ///< [rad] mean over that
    double spread = 0;      ///< [rad^2] variance of the innovation over that
  };

  /// A bearing compared with the features of its sensor and category.
  struct Match
  {
    Pose2 sensor;        ///< in odometry's axes
    double uniform = 0;  ///< density of the bearing if it shows something new
    FeatureDensities all;
    std::vector<double> in_view;      ///< probability of each feature
    std::optional<std::size_t> best;  ///< index of the likeliest feature
    PredictedBearing prediction;      ///< of that one
  };

  /// Where the feature may be: from the sensor, in odometry's axes.
  [[nodiscard]] static Candidates candidatesOf(const TrackedFeature& feature, const Pose2& sensor);
  [[nodiscard]] PredictedBearing predict(std::size_t index, const Pose2& sensor, const SensorModel& model,
                                         const Detection& bearing) const;
  [[nodiscard]] Match match(const Reading& reading, const Detection& bearing) const;
  /// An independent bearing, which each feature in view had a chance to cause.
  void countMissed(const Match& match);
  /// The best one was seen.
  void update(const Match& match, const Detection& bearing);
  void dropOldest();
  void add(const Reading& reading, const Pose2& sensor, const Detection& bearing);

  MotionModel motion_;
  double max_range_;
  DeadReckoning odometry_;  // since the start, its heading corrected by the features
  FeatureMixture mixture_;
  std::vector<TrackedFeature> features_;
  HeadingAndDirections errors_;  // of odometry_ and features_
  std::size_t bearings_ = 0;     // seen so far
};
}  // namespace mrpt_ext
