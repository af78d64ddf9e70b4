#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/feature_mixture.h"
#include "mrpt_ext/filter/integrity/relative_points.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Null hypothesis of the pose test for detections with bearing and range (null_model.h is that for bearings alone):
/// what a robot without a map expects to measure. A static feature is seen again where it was seen before, as far as
/// odometry, and the other features, tell how the robot has moved since.
///
/// A wrong pose that fits two posts of a fence goes on to fit them, metre after metre. Compared with a uniform density
/// each time would be evidence; compared with this model only features that are seen for the first time are, or again
/// after odometry has lost them. Correlated detections count for neither, but the particles follow the robot by them,
/// and so does this model: with odometry alone in the meantime any pose would seem better.
///
/// Features have the rates of null_model.h: when one is lost is not known.
class PointNullModel
{
 public:
  /// `max_range` [m]: of a sensor that declares none.
  PointNullModel(const MotionModel& motion, double max_range) : motion_(motion), max_range_(max_range) {}

  void clear() { *this = PointNullModel(motion_, max_range_); }
  void move(const OdometryMotion& motion);
  /// The log density of the result is that of a detection [1/(m rad)], clutter included, given those before; the
  /// detection is remembered. It has both bearing and range.
  FeatureMixture::Outcome observe(const Reading& reading, const Detection& detection);
  /// A detection that is correlated with those before moves the feature that it shows, unless it rather shows something
  /// else. It does not count among those that tell how frequent new ones are, nor is it a new one.
  void track(const Reading& reading, const Detection& detection);

  /// Number of tracked features.
  [[nodiscard]] std::size_t size() const { return features_.size(); }

 private:
  struct TrackedPoint
  {
    std::string sensor, category;
    std::size_t seen = 0;  ///< number of the last detection
    double missed = 0;     ///< independent detections since the last one, while it was in view
  };
  /// A detection compared with the features of its sensor and category.
  struct Match
  {
    Vector2d position;    ///< in the axes of the robot
    Matrix2d covariance;  ///< of it
    double uniform = 0;   ///< density of the detection if it shows something new
    FeatureDensities all;
    std::vector<bool> in_view;        ///< of each feature
    std::optional<std::size_t> best;  ///< index of the likeliest feature
    double share = 0;                 ///< of it among the features
  };

  [[nodiscard]] Match match(const Reading& reading, const Detection& detection) const;
  /// The best one was seen.
  void update(const Match& match);
  void add(const Reading& reading, const Detection& detection, const Match& match);

  MotionModel motion_;
  double max_range_;
  FeatureMixture mixture_;
  std::vector<TrackedPoint> features_;
  RelativePoints points_;       // where they are
  std::size_t detections_ = 0;  // seen so far
};
}  // namespace mrpt_ext
