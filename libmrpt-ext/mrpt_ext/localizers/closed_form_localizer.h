#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// What a closed form finds in one frame: all candidates, with a log-score where it can tell them apart. Candidates
/// with another status than `ok` are answers in doubt: they are reported, with the verdict `ambiguous`.
struct ClosedFormAnswer
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet candidates;
  bool unique = true;  ///< false: even a single candidate is not sure to be the right one
};

/// A stateless closed form behind the common interface. It reports its best-scoring candidate; candidates with equal
/// scores cannot be ranked and count as ambiguous, without an estimate.
class ClosedFormLocalizer : public Localizer
{
 public:
  using Method = std::function<ClosedFormAnswer(const Frame&)>;
  ClosedFormLocalizer(std::string name, Method method) : name_(std::move(name)), method_(std::move(method)) {}

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] bool continuous() const override { return false; }
  Estimate process(const Frame& frame) override;

 private:
  std::string name_;
  Method method_;
};

/// Ranks the candidates and turns the answer into an estimate at `time`.
[[nodiscard]] Estimate estimateFrom(ClosedFormAnswer answer, double time);
}  // namespace mrpt_ext
