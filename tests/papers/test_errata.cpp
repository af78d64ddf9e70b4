#include <gtest/gtest.h>

#include <set>

#include "errata.h"

namespace mrpt_ext::papers::test_errata
{
class PrintedFormula : public ::testing::TestWithParam<Erratum>
{
};

// One test per erratum: random exact examples, on which a right formula errs by rounding only.
TEST_P(PrintedFormula, IsWrongAndRightWhenCorrected)
{
  EXPECT_GT(GetParam().printed_error, 0.1) << GetParam().measure;
  EXPECT_LT(GetParam().corrected_error, 1e-6) << GetParam().measure;
}

INSTANTIATE_TEST_SUITE_P(Papers, PrintedFormula, ::testing::ValuesIn(allErrata()),
                         [](const auto& erratum) { return testName(erratum.param); });

TEST(Errata, EachHasATestOfItsOwn)
{
  std::set<std::string> names;
  for (const Erratum& erratum : allErrata()) names.insert(testName(erratum));
  EXPECT_EQ(names.size(), allErrata().size());
}
}  // namespace mrpt_ext::papers::test_errata
