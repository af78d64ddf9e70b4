#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// Result of a closed form for one frame: all candidates, with a log-score if it can rank them. Candidates with a
/// status other than `ok` are reported with the verdict `ambiguous`, and so are imprecise ones.
struct ClosedFormResult
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet candidates;
  bool unique = true;  ///< false: even a single candidate may be wrong
};

/// How precise `ok` is: 95 % of the error that an estimate states are within.
struct ErrorLimits
{
  double position = std::numeric_limits<double>::infinity();  ///< [m]
  double heading = std::numeric_limits<double>::infinity();   ///< [rad] where it is known
};

/// A closed form, without memory, behind the interface of localizers. It reports the candidate with the best score;
/// equal scores are ambiguous and give no estimate.
class ClosedFormLocalizer : public Localizer
{
 public:
  using Method = std::function<ClosedFormResult(const Frame&)>;
  ClosedFormLocalizer(std::string name, Method method, const ErrorLimits& limits = {})
      : name_(std::move(name)), method_(std::move(method)), limits_(limits)
  {
  }

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override;

 private:
  std::string name_;
  Method method_;
  ErrorLimits limits_;
};

/// Ranks the candidates and turns the result into an estimate at `time`.
[[nodiscard]] Estimate estimateFrom(ClosedFormResult result, double time, const ErrorLimits& limits = {});
}  // namespace mrpt_ext
