#include "mrpt_ext/localizers/filter_localizer.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_filter_localizer
{
namespace
{
Mode mode(double x, double phi, double weight)
{
  return {{{x, 0, phi}, Vector3d(0.01, 0.02, 0.0025).asDiagonal()}, weight};
}

FilterStep stepWith(std::vector<Mode> modes, Verdict verdict)
{
  FilterStep step;
  step.modes.modes = std::move(modes);
  step.verdict = verdict;
  step.effective_ratio = 0.4;
  return step;
}

/// A filter that has just made a given step.
class FixedFilter : public FilterLocalizer
{
 public:
  explicit FixedFilter(FilterStep step) : step_(std::move(step)) {}
  Estimate process(const Frame& frame) override { return estimateFrom(step_, frame.time); }
  [[nodiscard]] const FilterStep& lastStep() const override { return step_; }
  [[nodiscard]] const ParticleSet& particles() const override { return particles_; }
  [[nodiscard]] std::vector<LandmarkHistory> landmarkHistories() const override { return {}; }

 private:
  FilterStep step_;
  ParticleSet particles_;
};
}  // namespace

TEST(FilterLocalizer, TheEstimateIsTheBestModeNotTheMean)
{
  const Estimate estimate = estimateFrom(stepWith({mode(-2, 1, 0.6), mode(5, 2, 0.4)}, Verdict::ambiguous), 9);
  ASSERT_TRUE(estimate.point);
  EXPECT_EQ(estimate.point->time, 9);
  EXPECT_EQ(estimate.point->pose.mean.x, -2);
  EXPECT_EQ(estimate.point->pose.covariance(2, 2), 0.0025);
  EXPECT_EQ(estimate.point->best_weight, 0.6);
  EXPECT_EQ(estimate.point->modes, 2);
  EXPECT_EQ(estimate.point->effective_samples, 0.4);
  EXPECT_EQ(estimate.point->verdict, Verdict::ambiguous);
  EXPECT_TRUE(estimate.ambiguous);
  ASSERT_EQ(estimate.candidates.size(), 2u);
  EXPECT_EQ(estimate.candidates[1].pose.mean.x, 5);
  EXPECT_EQ(estimate.candidates[1].weight, 0.4);
  EXPECT_NEAR(estimate.candidates[1].log_score, std::log(0.4), 1e-12);
}

TEST(FilterLocalizer, NegligibleModesAreNotListed)
{
  const FilterStep step = stepWith({mode(0, 0, 0.999), mode(1, 0, 0.001)}, Verdict::ok);
  EXPECT_EQ(estimateFrom(step, 0).candidates.size(), 1u);
  EXPECT_FALSE(estimateFrom(step, 0).ambiguous);
  const FilterStep many = stepWith(std::vector<Mode>(100, mode(0, 0, 0.01)), Verdict::ambiguous);
  EXPECT_EQ(estimateFrom(many, 0).candidates.size(), 20u);
}

TEST(FilterLocalizer, NoModesNoEstimate) { EXPECT_FALSE(estimateFrom(FilterStep{}, 0).point); }

TEST(FilterLocalizer, TheHeadingIsGivenOnlyWhileTheVerdictIsOk)
{
  const auto heading = confidentHeading(FixedFilter(stepWith({mode(0, 2, 0.95), mode(1, 0, 0.05)}, Verdict::ok)));
  ASSERT_TRUE(heading);
  EXPECT_EQ(heading->heading, 2);
  EXPECT_NEAR(heading->std_heading, 0.05, 1e-12);
  EXPECT_FALSE(confidentHeading(FixedFilter(stepWith({mode(0, 2, 1)}, Verdict::ambiguous))));
  EXPECT_FALSE(confidentHeading(FixedFilter(stepWith({mode(0, 2, 1)}, Verdict::lost))));
  EXPECT_FALSE(confidentHeading(FixedFilter(stepWith({}, Verdict::ok))));
}
}  // namespace mrpt_ext::test_filter_localizer
