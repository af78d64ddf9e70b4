#include "mrpt_ext/experiment/trial_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace mrpt_ext::test_trial_pool
{
TEST(TrialPool, EveryTrialRunsOnceHoweverManyThreads)
{
  for (const unsigned threads : {0U, 1U, 2U, 7U})
  {
    std::vector<std::atomic<int>> runs(20);
    runTrials(5, 20, threads, [&](int trial) { ++runs[static_cast<std::size_t>(trial)]; });
    for (int trial = 0; trial < 20; ++trial)
      EXPECT_EQ(runs[static_cast<std::size_t>(trial)], trial >= 5 ? 1 : 0) << threads << " threads";
  }
}

TEST(TrialPool, NoMoreThanTheGivenNumberAtOnce)
{
  std::atomic<int> now = 0, most = 0;
  runTrials(0, 60, 3,
            [&](int)
            {
              const int running = ++now;
              int seen = most;
              while (running > seen && !most.compare_exchange_weak(seen, running))
              {
              }
              std::this_thread::yield();
              --now;
            });
  EXPECT_GE(most, 1);
  EXPECT_LE(most, 3);
}

TEST(TrialPool, TwoThreadsRunConcurrently)
{
  // Each trial waits for the other: with one at a time this would never end.
  std::atomic<int> arrived = 0;
  runTrials(0, 2, 2,
            [&](int)
            {
              ++arrived;
              arrived.notify_all();
              for (int seen = arrived; seen < 2; seen = arrived) arrived.wait(seen);
            });
  EXPECT_EQ(arrived, 2);
}

TEST(TrialPool, EveryTrialHasANewThread)
{
  thread_local int left_by_another = 0;
  std::atomic<int> fresh = 0;
  runTrials(0, 12, 2, [&](int) { fresh += left_by_another++ == 0 ? 1 : 0; });
  EXPECT_EQ(fresh, 12);
}

TEST(TrialPool, TheFirstFailureStopsTheRestAndComesOut)
{
  std::set<int> ran;
  std::mutex mutex;
  const auto work = [&](int trial)
  {
    const std::lock_guard lock(mutex);
    ran.insert(trial);
    if (trial == 3) throw std::runtime_error("trial 3");
  };
  try
  {
    runTrials(0, 100, 1, work);
    FAIL() << "nothing was thrown";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(error.what(), std::string("trial 3"));
  }
  EXPECT_EQ(ran, (std::set<int>{0, 1, 2, 3}));
}

TEST(TrialPool, NoTrialsNoWork)
{
  runTrials(3, 3, 2, [](int) { FAIL(); });
  runTrials(3, 1, 2, [](int) { FAIL(); });
}
}  // namespace mrpt_ext::test_trial_pool
