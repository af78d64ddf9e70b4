#pragma once

#include <memory>

#include "mrpt_ext/localizers/localizer.h"
#include "mrpt_ext/relocalization/measurement_window.h"

namespace mrpt_ext
{
/// A closed form that sees the readings of the last seconds as one constellation: `<name>_joined`.
class WindowedLocalizer : public Localizer
{
 public:
  WindowedLocalizer(std::unique_ptr<Localizer> inner, double window, const MotionModel& motion)
      : inner_(std::move(inner)), joiner_(window, motion)
  {
  }

  [[nodiscard]] std::string name() const override { return inner_->name() + "_joined"; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override
  {
    joiner_.add(frame);
    return inner_->process(joiner_.joined());
  }

 private:
  std::unique_ptr<Localizer> inner_;
  MeasurementWindow joiner_;
};
}  // namespace mrpt_ext
