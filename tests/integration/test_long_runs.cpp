#include <gtest/gtest.h>

#include "allocation_peak.h"
#include "scratch_folder.h"
#include "test_length.h"
#include "whole_runs.h"

// A log may be of any length: what a run keeps of every second is little, and every file is as complete as ever.
namespace mrpt_ext::test_long_runs
{
namespace
{
using testing::Arguments;

class LongRuns : public ::testing::Test
{
 protected:
  /// Most memory that the run over the first `seconds` of the log had at one time [bytes].
  std::size_t peakOf(int seconds, const Arguments& more)
  {
    const std::size_t before = allocatedBytes();
    startPeak();
    run_ = testing::localized(
        folder_.path(), "long",
        testing::joined(testing::joined(log_.arguments(), {"--duration", std::to_string(seconds), "--set",
                                                           "LocalizationExperiment.particles_count=100"}),
                        more));
    return peakBytes() - before;
  }

  const int short_ = testing::isShort() ? 100 : 1500, long_ = 2 * short_;  // s
  testing::ScratchFolder folder_;
  testing::LogFiles log_ =
      testing::simulated(folder_.path(), "long", {"--set", "Simulation.duration_s=" + std::to_string(long_)});
  std::filesystem::path run_;
};
}  // namespace

TEST_F(LongRuns, MemoryHardlyGrowsWithTheLog)
{
  // Ten poses of odometry, five frames of two methods: their measurements and estimates alone would be 10 000 bytes.
  constexpr std::size_t kPerSecond = 2500;
  const std::size_t little = peakOf(short_, {}), much = peakOf(long_, {});
  RecordProperty("bytes_per_second", std::to_string((much - little) / (long_ - short_)));
  if (!testing::isShort())
  {
    EXPECT_LT(much, little + kPerSecond * (long_ - short_)) << "short: " << little;
  }
  EXPECT_EQ(testing::stepsOf(run_).size(), 5U * long_ + 1);
  EXPECT_EQ(testing::stepsOf(run_, "odometry").size(), 5U * long_ + 1);
}

TEST_F(LongRuns, ClosedFormsBesideTheFilterKeepAsLittle)
{
  constexpr std::size_t kPerSecond = 4000;
  const Arguments methods{"--set",
                          "LocalizationExperiment.methods=particle_filter odometry extended_kalman_filter "
                          "two_landmark_pose"};
  const std::size_t little = peakOf(short_, methods), much = peakOf(long_, methods);
  if (!testing::isShort())
  {
    EXPECT_LT(much, little + kPerSecond * (long_ - short_)) << "short: " << little;
  }
}
}  // namespace mrpt_ext::test_long_runs
