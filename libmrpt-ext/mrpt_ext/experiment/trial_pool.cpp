#include "mrpt_ext/experiment/trial_pool.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <semaphore>
#include <thread>
#include <vector>

namespace mrpt_ext
{
void runTrials(int first, int last, unsigned threads, const std::function<void(int trial)>& work)
{
  std::counting_semaphore<> free_slots(std::max(1U, threads));
  std::mutex mutex;
  std::exception_ptr failure;
  const auto failed = [&]
  {
    const std::lock_guard lock(mutex);
    return failure != nullptr;
  };
  std::vector<std::jthread> running;
  for (int trial = first; trial < last; ++trial)
  {
    free_slots.acquire();
    if (failed()) break;
    running.emplace_back(
        [&, trial]
        {
          try
          {
            work(trial);
          }
          catch (...)
          {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
          }
          free_slots.release();
        });
  }
  running.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}
}  // namespace mrpt_ext
