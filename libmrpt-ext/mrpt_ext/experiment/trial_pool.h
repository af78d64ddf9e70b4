#pragma once

#include <functional>

namespace mrpt_ext
{
/// Calls work(trial) for trials first ... last - 1, at most `threads` at a time, each in a new thread (MRPT keeps one
/// random generator per thread). The first exception stops further trials and is thrown again at the end.
void runTrials(int first, int last, unsigned threads, const std::function<void(int trial)>& work);
}  // namespace mrpt_ext
