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
      : max_range_(max_range), bearings_(motion, max_range), points_(motion, max_range)
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
  /// The only detection of a reading; it is remembered.
  FeatureMixture::Outcome observe(const Reading& part);
  /// Follows the features that correlated detections show, which do not count.
  void track(const Reading& correlated);

 private:
  double max_range_;
  NullModel bearings_;
  PointNullModel points_;
};
}  // namespace mrpt_ext
