#include "errata.h"
#include "sections.h"

namespace mrpt_ext::papers
{
namespace
{
/// Three digits, or "below 1e-6" for what is rounding: its last digits belong to the machine.
std::string errorText(double error)
{
  if (error < 1e-6) return "below 1e-6";
  if (error > 1e8) return "no number";
  return fixedText(error, error < 10 ? 2 : (error < 100 ? 1 : 0));
}
}  // namespace

ResultSection sectionErrata()
{
  ResultSection s;
  s.title = "Errata of the papers";
  s.paragraph =
      "Every formula and statement of the three papers that is wrong in print, with what it does on two hundred "
      "random exact examples (median error) and what the corrected form does on the same (largest error). Each row is "
      "a test of its own, `Papers/PrintedFormula.IsWrongAndRightWhenCorrected/<name>` of `build/bin/test_papers`. The "
      "formulas that are not listed are right as printed.";
  s.plain.push_back({"where", "print", "right", "error of", "as printed", "corrected", "test"});
  for (const Erratum& e : allErrata())
    s.plain.push_back({e.where, e.print, e.right, e.measure, errorText(e.printed_error), errorText(e.corrected_error),
                       std::string("`").append(testName(e)).append("`")});
  return s;
}
}  // namespace mrpt_ext::papers
