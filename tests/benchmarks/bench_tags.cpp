#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>

#include "mrpt_ext/vision/tags/tag_view.h"

// Fiducial tags in one image of 640 x 480 pixels on one core; a frame of a camera lasts 33 ms.
namespace mrpt_ext
{
namespace
{
/// The camera of datasets/tags.
TagSettings hallSettings(double decimation)
{
  TagSettings settings;
  settings.camera.size = {640, 480};
  settings.camera.fx = settings.camera.fy = 440.442;
  settings.camera.cx = 319.5, settings.camera.cy = 239.5;
  settings.camera.k1 = -0.21, settings.camera.k2 = 0.06;
  settings.edge = 0.2;
  settings.detector.decimation = decimation;
  return settings;
}

void tags(benchmark::State& state, double decimation)
{
  cv::setNumThreads(1);
  const cv::Mat image = cv::imread(MRPT_EXT_SOURCE_DIR "/datasets/tags/hall_10.jpg", cv::IMREAD_GRAYSCALE);
  if (image.empty()) return state.SkipWithError("datasets/tags/hall_10.jpg cannot be read");
  const TagSettings settings = hallSettings(decimation);
  const TagDetector detector(settings.detector);
  std::size_t seen = 0;
  for (auto _ : state) seen = viewTags(image, detector, settings).tags.size();
  state.counters["tags"] = static_cast<double>(seen);
}
BENCHMARK_CAPTURE(tags, ours, 1.5)->Name("vision/tags/ours")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tags, full_size, 1)->Name("vision/tags/full_size")->Unit(benchmark::kMillisecond);

/// Bearing and range with covariance from corners that are known.
void tagMeasurement(benchmark::State& state)
{
  const TagSettings settings = hallSettings(1.5);
  const TagCorners corners{Eigen::Vector2d(300, 200), {330, 203}, {329, 235}, {299, 230}};
  for (auto _ : state) benchmark::DoNotOptimize(measureTag(corners, 0.2, settings.camera, settings.noise));
}
BENCHMARK(tagMeasurement)->Name("vision/tag_measurement/ours")->Unit(benchmark::kMicrosecond);
}  // namespace
}  // namespace mrpt_ext
