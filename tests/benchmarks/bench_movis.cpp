#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/vision/omni_objects.h"

// Poles and ball in one image of an omnidirectional camera of 480 x 480 pixels, as large as paper 001's useful part of
// a video frame, on one core; and OpenCV's way to find coloured patches in the same image, without measuring them.
namespace mrpt_ext
{
namespace
{
constexpr double kEnlarged = 1.5;  // of the images that come with the project, 320 x 320

cv::Mat sampleImage(benchmark::State& state)
{
  cv::setNumThreads(1);
  cv::Mat image = cv::imread(MRPT_EXT_SOURCE_DIR "/datasets/movis-field/field_05_M1.jpg");
  if (image.empty())
    state.SkipWithError("datasets/movis-field/field_05_M1.jpg cannot be read");
  else
    cv::resize(image, image, {480, 480}, 0, 0, cv::INTER_CUBIC);
  return image;
}

OmniCamera sampleCamera()
{
  OmniCameraSettings settings;
  settings.mirror = {
      0.03, 0.024, 0.031, 0.62, 423 * kEnlarged, 423 * kEnlarged, {160.9 * kEnlarged, 159.2 * kEnlarged}};
  settings.mirror.centre -= {0.5, 0.5};
  settings.sizes = {0.1, 1.0, 0.11};
  return OmniCamera(settings);
}

void movis(benchmark::State& state)
{
  const cv::Mat image = sampleImage(state);
  const OmniCamera camera = sampleCamera();
  std::size_t objects = 0;
  for (auto _ : state) objects = camera.view(image).objects.size();
  state.counters["objects"] = static_cast<double>(objects);
}
BENCHMARK(movis)->Name("vision/movis/ours")->Unit(benchmark::kMillisecond);

/// Hue thresholds and connected patches of three colours, in the image as it is.
void colouredPatches(benchmark::State& state)
{
  const cv::Mat image = sampleImage(state);
  const std::pair<int, int> hues[] = {{3, 16}, {17, 35}, {100, 130}};  // of OpenCV, half degrees
  int patches = 0;
  for (auto _ : state)
  {
    cv::Mat hsv, mask, labels, figures, centres;
    cv::cvtColor(image, hsv, cv::COLOR_BGR2HSV);
    patches = 0;
    for (const auto& [low, high] : hues)
    {
      cv::inRange(hsv, cv::Scalar(low, 120, 40), cv::Scalar(high, 255, 255), mask);
      patches += cv::connectedComponentsWithStats(mask, labels, figures, centres) - 1;
    }
  }
  state.counters["patches"] = patches;
}
BENCHMARK(colouredPatches)->Name("vision/movis/plain")->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace mrpt_ext
