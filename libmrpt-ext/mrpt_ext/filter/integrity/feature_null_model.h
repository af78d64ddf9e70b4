#pragma once

#include "mrpt_ext/filter/integrity/null_model.h"
#include "mrpt_ext/filter/integrity/point_null_model.h"

namespace mrpt_ext
{
/// Null hypothesis for single detections of any kind: features without a map for anonymous ones with a bearing
/// (null_model.h, point_null_model.h), uniform densities for all others.
class FeatureNullModel
{
 public:
  /// `max_range` [m]: of a sensor that declares none.
  FeatureNullModel(const MotionModel& motion, double max_range)
      : bearings_(motion, max_range), points_(motion, max_range)
  {
  }

  void clear()
  {
    bearings_.clear();
    points_.clear();
  }
  void move(const OdometryMotion& motion)
  {
    bearings_.move(motion);
    points_.move(motion);
  }
  /// The only detection of a reading; it is remembered. `max_range` [m]: of a sensor that declares none.
  FeatureMixture::Outcome observe(const Reading& part, double max_range);
  /// Follows the features that correlated detections show, which do not count.
  void track(const Reading& correlated);

  /// Number of tracked features.
  [[nodiscard]] std::size_t size() const { return bearings_.size() + points_.size(); }

 private:
  NullModel bearings_;
  PointNullModel points_;
};
}  // namespace mrpt_ext
