#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/vision/stereo/stereo_goal.h"

// Goal corners and line landmarks of one stereo pair of 320 x 240 pixels on one core; a frame of a camera lasts 33 ms.
namespace mrpt_ext
{
namespace
{
struct Pair
{
  cv::Mat left, right;
};

/// A pair with both corners of a goal and a junction.
Pair samplePair(benchmark::State& state)
{
  cv::setNumThreads(1);
  const std::string stem = MRPT_EXT_SOURCE_DIR "/datasets/stereo-goal/field_05_";
  Pair pair{cv::imread(stem + "L.jpg"), cv::imread(stem + "R.jpg")};
  if (pair.left.empty() || pair.right.empty()) state.SkipWithError("datasets/stereo-goal/field_05 cannot be read");
  return pair;
}

/// The camera of datasets/stereo-goal.
StereoGoalSettings sampleSettings()
{
  StereoGoalSettings settings;
  settings.camera.size = {320, 240};
  settings.camera.fx = settings.camera.fy = 288.6476;
  settings.camera.cx = 159.5, settings.camera.cy = 119.5;
  settings.camera.baseline = 0.03, settings.camera.height = 0.058, settings.camera.pitch = 0.1221730;
  return settings;
}

template <int step>
void goalCorners(benchmark::State& state)
{
  const Pair pair = samplePair(state);
  StereoGoalSettings settings = sampleSettings();
  settings.with_lines = false;
  settings.corners.scan_step = step;
  std::size_t corners = 0;
  for (auto _ : state) corners = viewStereoGoal(pair.left, pair.right, settings).corners.size();
  state.counters["corners"] = static_cast<double>(corners);
}
BENCHMARK(goalCorners<4>)->Name("vision/goal_corners/ours")->Unit(benchmark::kMillisecond);
BENCHMARK(goalCorners<1>)->Name("vision/goal_corners/full_scan")->Unit(benchmark::kMillisecond);

/// The scan alone: a sixteenth of the pixels and all of them.
template <int step>
void scan(benchmark::State& state)
{
  const Pair pair = samplePair(state);
  GoalCornerSettings settings;
  settings.scan_step = step;
  std::size_t candidates = 0;
  for (auto _ : state) candidates = scanForGoals(pair.left, settings).size();
  state.counters["candidates"] = static_cast<double>(candidates);
}
BENCHMARK(scan<4>)->Name("vision/goal_scan/ours")->Unit(benchmark::kMillisecond);
BENCHMARK(scan<1>)->Name("vision/goal_scan/full_scan")->Unit(benchmark::kMillisecond);

/// OpenCV's line segments of both images, without junctions and without distances.
void segmentSearch(benchmark::State& state)
{
  const Pair pair = samplePair(state);
  std::vector<cv::Vec4i> segments;
  cv::Mat grey, edges;
  for (auto _ : state)
    for (const cv::Mat* image : {&pair.left, &pair.right})
    {
      cv::cvtColor(*image, grey, cv::COLOR_BGR2GRAY);
      cv::Canny(grey, edges, 40, 100);
      cv::HoughLinesP(edges, segments, 1, CV_PI / 180, 20, 15, 4);
    }
  state.counters["segments"] = static_cast<double>(segments.size());
}
BENCHMARK(segmentSearch)->Name("vision/lines/plain")->Unit(benchmark::kMillisecond);

void lines(benchmark::State& state)
{
  const Pair pair = samplePair(state);
  StereoGoalSettings settings = sampleSettings();
  settings.with_corners = false;
  std::size_t landmarks = 0;
  for (auto _ : state) landmarks = viewStereoGoal(pair.left, pair.right, settings).landmarks.size();
  state.counters["landmarks"] = static_cast<double>(landmarks);
}
BENCHMARK(lines)->Name("vision/lines/ours")->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace mrpt_ext
