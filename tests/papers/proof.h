#pragma once

#include "errata.h"
#include "mrpt_ext/geometry/random.h"
#include "sample.h"

namespace mrpt_ext::papers
{
/// Errors of a printed and of the corrected formula over examples.
class Proof
{
 public:
  void add(double printed, double corrected)
  {
    printed_.add(std::isfinite(printed) ? printed : kNotANumber);
    corrected_.add(std::isfinite(corrected) ? corrected : kNotANumber);
  }
  [[nodiscard]] Erratum erratum(std::string where, std::string print, std::string right, std::string measure) const
  {
    return {std::move(where),   std::move(print),  std::move(right),
            std::move(measure), printed_.median(), corrected_.quantile(1)};
  }

 private:
  static constexpr double kNotANumber = 1e9;  // stands for the error of what is no number at all
  Sample printed_, corrected_;
};

inline constexpr int kExamples = 200;
}  // namespace mrpt_ext::papers
