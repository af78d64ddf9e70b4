#pragma once

#include <memory>

#include "mrpt_ext/localizers/localizer.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
/// A method without memory, applied to the readings of a sliding window: `<name>_joined`.
class WindowedLocalizer : public Localizer
{
 public:
  WindowedLocalizer(std::unique_ptr<Localizer> inner, double window, const MotionModel& motion)
      : inner_(std::move(inner)), window_(window, motion)
  {
  }

  [[nodiscard]] std::string name() const override { return inner_->name() + "_joined"; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override
  {
    window_.add(frame);
    return inner_->process(window_.frame());
  }

 private:
  std::unique_ptr<Localizer> inner_;
  MeasurementWindow window_;
};
}  // namespace mrpt_ext
