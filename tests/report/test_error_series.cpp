#include "mrpt_ext/report/error_series.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_error_series
{
using namespace testing;

namespace
{
double worst(const std::vector<OptionalNumber>& errors)
{
  double largest = 0;
  for (const OptionalNumber& error : errors) largest = std::max(largest, error.value_or(0));
  return largest;
}
}  // namespace

TEST(ErrorSeries, HasOneEntryPerStampAndMethod)
{
  const RunContext context = syntheticContext();
  const RunScore score = scoreRun(context, syntheticRecord(context), {});
  const ErrorSeries series = errorSeries(context, score, 1000);
  EXPECT_EQ(series.stamps.size(), 121u);
  EXPECT_EQ(series.stamps_per_entry, 1u);
  ASSERT_EQ(series.position_m.size(), score.methods.size());
  const auto filter = std::find_if(score.methods.begin(), score.methods.end(),
                                   [](const MethodScore& method) { return method.name == "particle_filter"; });
  const auto& errors = series.position_m[static_cast<std::size_t>(filter - score.methods.begin())];
  EXPECT_EQ(errors[50], filter->errors[50].position_m);
}

TEST(ErrorSeries, MergedStampsKeepTheLargestError)
{
  const RunContext context = syntheticContext();
  const RunScore score = scoreRun(context, syntheticRecord(context), {});
  const ErrorSeries all = errorSeries(context, score, 1000), few = errorSeries(context, score, 30);
  EXPECT_LE(few.stamps.size(), 30u);
  EXPECT_EQ(few.stamps_per_entry, 5u);
  for (std::size_t m = 0; m < score.methods.size(); ++m) EXPECT_EQ(worst(few.position_m[m]), worst(all.position_m[m]));
}

TEST(ErrorSeries, WithoutTruthIsEmpty) { EXPECT_TRUE(errorSeries(RunContext{}, RunScore{}, 10).stamps.empty()); }
}  // namespace mrpt_ext::test_error_series
