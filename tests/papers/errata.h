#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace mrpt_ext::papers
{
/// A mistake in print, shown on random examples: the formula as printed errs, the corrected one does not.
struct Erratum
{
  std::string where;           ///< "000, eq 1"
  std::string print, right;    ///< what is there, what should be
  std::string measure;         ///< what the errors are of, with the unit
  double printed_error = 0;    ///< median over the examples
  double corrected_error = 0;  ///< largest over the examples
};

[[nodiscard]] std::vector<Erratum> errataOfPaper000();
[[nodiscard]] std::vector<Erratum> errataOfPaper001();
[[nodiscard]] std::vector<Erratum> errataOfPaper004();
[[nodiscard]] std::vector<Erratum> allErrata();

/// Name of the gtest that holds it: Paper000_eq_1.
[[nodiscard]] std::string testName(const Erratum& erratum);

/// For the messages of tests.
inline std::ostream& operator<<(std::ostream& out, const Erratum& erratum) { return out << erratum.where; }
}  // namespace mrpt_ext::papers
