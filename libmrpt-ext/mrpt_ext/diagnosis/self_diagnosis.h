#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/diagnosis/frame_window_check.h"
#include "mrpt_ext/diagnosis/innovation_observer.h"
#include "mrpt_ext/diagnosis/map_agreement.h"

namespace mrpt_ext
{
/// All checks of one trial. Never uses the truth.
class SelfDiagnosis
{
 public:
  /// `input` must outlive it.
  explicit SelfDiagnosis(const LocalizationInput& input)
      : input_(input), innovations_(input), landmarks_(input.context.map)
  {
  }

  /// Every frame, with the filter after it.
  void add(const Frame& frame, const FilterLocalizer& filter);
  /// `landmarks`: statistics of the filter at the end. One line for each finding, with the command that helps; of a run
  /// as it should be: none.
  [[nodiscard]] std::vector<std::string> hints(const std::map<std::string, LandmarkRecord>& landmarks) const;

 private:
  const LocalizationInput& input_;
  InnovationObserver innovations_;
  FrameWindowCheck joined_;
  LandmarkCheck landmarks_;
  MapAgreement agreement_;
};
}  // namespace mrpt_ext
