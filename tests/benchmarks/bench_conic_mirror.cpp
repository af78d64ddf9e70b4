#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/vision/conic_mirror.h"

// Edges of one image of 640 x 480 pixels on one core; a frame of a camera lasts 33 ms.
namespace mrpt_ext
{
namespace
{
cv::Mat sampleImage(benchmark::State& state)
{
  cv::setNumThreads(1);
  const cv::Mat image = cv::imread(MRPT_EXT_SOURCE_DIR "/datasets/conic-mirror/room_03.jpg", cv::IMREAD_GRAYSCALE);
  if (image.empty()) state.SkipWithError("datasets/conic-mirror/room_03.jpg cannot be read");
  return image;
}

void conicMirror(benchmark::State& state)
{
  const cv::Mat image = sampleImage(state);
  std::size_t edges = 0;
  for (auto _ : state) edges = viewConicMirror(image, {}).edges.size();
  state.counters["edges"] = static_cast<double>(edges);
}
BENCHMARK(conicMirror)->Name("vision/conic_mirror/ours")->Unit(benchmark::kMillisecond);

/// OpenCV's circle search, which gives the outline alone, of round mirrors, to some pixels.
void circleSearch(benchmark::State& state)
{
  const cv::Mat image = sampleImage(state);
  std::vector<cv::Vec3f> circles;
  for (auto _ : state) cv::HoughCircles(image, circles, cv::HOUGH_GRADIENT, 1.5, 200, 80, 40, 120, 320);
  state.counters["circles"] = static_cast<double>(circles.size());
}
BENCHMARK(circleSearch)->Name("vision/conic_mirror/plain")->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace mrpt_ext
