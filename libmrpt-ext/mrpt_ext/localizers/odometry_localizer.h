#pragma once

#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// Dead reckoning from a given pose, without landmarks; the covariance follows from the motion model.
class OdometryLocalizer : public Localizer
{
 public:
  OdometryLocalizer(const MotionModel& motion, const GaussianPose& start) : motion_(motion), pose_(start) {}

  [[nodiscard]] std::string name() const override { return "odometry"; }
  [[nodiscard]] bool continuous() const override { return true; }
  Estimate process(const Frame& frame) override;

 private:
  MotionModel motion_;
  GaussianPose pose_;
};
}  // namespace mrpt_ext
