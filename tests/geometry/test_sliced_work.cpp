#include "mrpt_ext/geometry/sliced_work.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace mrpt_ext::test_sliced_work
{
namespace
{
/// Parts of ten operations each.
std::function<void()> parts(int count, std::vector<int>& done)
{
  return [count, &done]
  {
    for (int k = 0; k < count; ++k)
    {
      done.push_back(k);
      WorkCounter::add(10);
    }
  };
}
}  // namespace

TEST(SlicedWork, GoesOnWhereTheSliceBeforeEnded)
{
  std::vector<int> done;
  SlicedWork work;
  work.begin(parts(7, done));
  EXPECT_TRUE(done.empty());
  EXPECT_EQ(work.resume(35), 0U);
  EXPECT_EQ(done.size(), 4U) << "a part is not divided";
  EXPECT_EQ(work.resume(20), 0U);
  EXPECT_EQ(done.size(), 6U);
  EXPECT_FALSE(work.isDone());
  EXPECT_EQ(work.resume(30), 20U) << "what is left of the slice";
  EXPECT_TRUE(work.isDone());
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(SlicedWork, DoesOneWorkAfterTheOther)
{
  std::vector<int> first, second;
  SlicedWork work;
  EXPECT_EQ(work.resume(5), 5U) << "there is none";
  work.begin(parts(2, first));
  EXPECT_EQ(work.resume(10), 0U);
  EXPECT_EQ(work.resume(SlicedWork::kUnlimited), SlicedWork::kUnlimited - 10);
  work.begin(parts(3, second));
  EXPECT_EQ(work.resume(100), 70U);
  EXPECT_EQ(first.size(), 2U);
  EXPECT_EQ(second.size(), 3U);
}

TEST(SlicedWork, WithoutALimitItIsDoneByTheCaller)
{
  const std::thread::id here = std::this_thread::get_id();
  std::thread::id there;
  SlicedWork work;
  work.begin([&] { there = std::this_thread::get_id(); });
  (void)work.resume(SlicedWork::kUnlimited);
  EXPECT_TRUE(work.isDone());
  EXPECT_EQ(here, there);
  EXPECT_EQ(work.cpuSeconds(), 0);
}

TEST(SlicedWork, CountsForTheCaller)
{
  std::vector<int> done;
  SlicedWork work;
  work.begin(parts(5, done));
  const std::uint64_t before = WorkCounter::done();
  (void)work.resume(30);
  EXPECT_EQ(WorkCounter::done() - before, 30U);
  (void)work.resume(30);
  EXPECT_EQ(WorkCounter::done() - before, 50U);
}

TEST(SlicedWork, WhatOtherThreadsTakePartInIsNotDivided)
{
  std::vector<int> done;
  SlicedWork work;
  work.begin(
      [&]
      {
        {
          const WorkCounter::Undivided all;
          parts(5, done)();
        }
        parts(1, done)();
      });
  (void)work.resume(10);
  EXPECT_EQ(done.size(), 5U);
  EXPECT_FALSE(work.isDone());
  EXPECT_EQ(work.resume(20), 10U);
}

TEST(SlicedWork, IsDoneToItsEndByTheDestructor)
{
  std::vector<int> begun, never_begun;
  {
    SlicedWork first, second;
    first.begin(parts(100, begun));
    (void)first.resume(50);
    second.begin(parts(100, never_begun));
  }
  EXPECT_EQ(begun.size(), 100U);
  EXPECT_TRUE(never_begun.empty());
}

TEST(SlicedWork, ThrowsWhatTheWorkThrowsAndGoesOn)
{
  SlicedWork work;
  work.begin(
      []
      {
        WorkCounter::add(10);
        throw std::runtime_error("no");
      });
  EXPECT_EQ(work.resume(10), 0U);
  EXPECT_THROW((void)work.resume(10), std::runtime_error);
  EXPECT_TRUE(work.isDone());
  std::vector<int> done;
  work.begin(parts(1, done));
  EXPECT_EQ(work.resume(20), 10U);
}
}  // namespace mrpt_ext::test_sliced_work
