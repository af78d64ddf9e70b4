#include <gtest/gtest.h>

#include "mrpt_ext/files/text_file.h"
#include "scratch_folder.h"
#include "test_length.h"
#include "whole_runs.h"

// What a step of the particle filter may take changes no estimate: those of long steps come later.
namespace mrpt_ext::test_step_budget
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;

class StepBudget : public ::testing::TestWithParam<const char*>
{
 protected:
  /// The tables that a run with this budget leaves.
  std::string tables(const testing::LogFiles& log, const std::string& budget_ms)
  {
    const std::string key = "LocalizationExperiment.step_budget_ms=" + budget_ms;
    Arguments arguments = testing::joined(log.arguments(), {"--set", key});
    if (testing::isShort()) arguments = testing::joined(arguments, {"--duration", "8"});
    const fs::path run = testing::localized(folder_.path() / budget_ms, GetParam(), arguments);
    return readTextFile(run / "steps.csv") + readTextFile(run / "hypotheses.csv");
  }

  testing::ScratchFolder folder_;
};
}  // namespace

TEST_P(StepBudget, ChangesNoEstimate)
{
  const testing::LogFiles log = testing::simulated(folder_.path(), GetParam());
  const std::string without = tables(log, "0");
  EXPECT_GT(without.size(), 2000U);
  EXPECT_TRUE(tables(log, "2") == without);
  if (!testing::isShort())
  {
    EXPECT_TRUE(tables(log, "50") == without);
  }
}

INSTANTIATE_TEST_SUITE_P(OfSimulatedRuns, StepBudget, ::testing::Values("room", "kidnap", "symmetric"),
                         [](const auto& scenario) { return std::string(scenario.param); });
}  // namespace mrpt_ext::test_step_budget
