#include "mrpt_ext/vision/stereo/stereo_goal.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "mrpt_ext/vision/image_check.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRowsApart = 1.5;    ///< [px] of one junction in both images
constexpr double kFloorShare = 0.25;  ///< the disparity may differ from the floor's by this share, beside a pixel:
                                      ///< a degree of pitch is a tenth at the farthest markings
constexpr double kLeastStd = 1.0;     ///< [grey levels] an image with less shows nothing
constexpr int kSampled = 4;           ///< every fourth pixel of every fourth row tells it

/// [grey levels] standard deviations of the channels, summed.
double spreadOf(const cv::Mat& image)
{
  const int channels = image.channels();
  std::array<std::int64_t, 3> sums{}, squares{};
  std::int64_t count = 0;
  for (int row = 0; row < image.rows; row += kSampled)
  {
    const uchar* pixel = image.ptr<uchar>(row);
    for (int column = 0; column < image.cols; column += kSampled, pixel += kSampled * channels, ++count)
      for (int channel = 0; channel < channels; ++channel)
      {
        const auto i = static_cast<std::size_t>(channel);
        sums[i] += pixel[channel], squares[i] += pixel[channel] * pixel[channel];
      }
  }
  double spread = 0;
  for (std::size_t i = 0; i < 3; ++i)
    spread += std::sqrt(static_cast<double>(count * squares[i] - sums[i] * sums[i])) / static_cast<double>(count);
  return spread;
}

std::string complaint(const cv::Mat& image, const cv::Size& size, const char* side)
{
  std::string text = complaintAboutImage(image, size);
  if (text.empty() && spreadOf(image) < kLeastStd) text = "image is black or of one colour";
  return text.empty() ? "" : std::string(side) + " " + text;
}

/// Arms that one image does not show may be seen in the other; one image at least must show all.
bool mayBeTheSame(const FloorJunction& a, const FloorJunction& b)
{
  if (a.complete && b.complete) return a.kind == b.kind;
  return a.complete ? b.kind <= a.kind : b.complete && a.kind <= b.kind;
}
}  // namespace

std::vector<LineLandmark> findLineLandmarks(const FloorMarkings& left, const FloorMarkings& right,
                                            const StereoGoalSettings& settings)
{
  const StereoCamera& camera = settings.camera;
  std::vector<LineLandmark> landmarks;
  for (const FloorJunction& l : left.junctions)
  {
    const double depth = l.position.x() * std::cos(camera.pitch) + camera.height * std::sin(camera.pitch);
    const double on_floor = camera.disparityAt(depth);
    const FloorJunction* nearest = nullptr;
    double least = kFloorShare * on_floor + 1;
    for (const FloorJunction& r : right.junctions)
    {
      if (!mayBeTheSame(l, r) || std::abs(r.pixel.y - l.pixel.y) > kRowsApart) continue;
      const double off = std::abs(l.pixel.x - r.pixel.x - on_floor);
      if (off < least) least = off, nearest = &r;
    }
    if (!nearest) continue;
    const auto measured =
        measureStereo(camera, l.pixel, l.pixel.x - nearest->pixel.x, l.std_u, std::hypot(l.std_u, nearest->std_u));
    if (measured) landmarks.push_back({std::max(l.kind, nearest->kind), l.pixel, nearest->pixel, *measured});
  }
  return landmarks;
}

StereoGoalView viewStereoGoal(const cv::Mat& left, const cv::Mat& right, const StereoGoalSettings& settings)
{
  StereoGoalView view;
  view.problem = complaint(left, settings.camera.size, "left");
  if (view.problem.empty()) view.problem = complaint(right, settings.camera.size, "right");
  if (view.problem.empty() && left.type() != right.type()) view.problem = "left and right image differ in channels";
  if (!view.problem.empty()) return view;
  if (settings.with_corners)
  {
    if (left.channels() == 3)
      view.corners = findGoalCorners(left, right, settings.camera, settings.corners);
    else
      view.problem = "image is grey, goals are known by their colour";
  }
  if (settings.with_lines)
  {
    view.markings = findFloorJunctions(whitenessOf(left), settings.camera, settings.markings);
    const FloorMarkings in_right = findFloorJunctions(whitenessOf(right), settings.camera, settings.markings);
    view.landmarks = findLineLandmarks(view.markings, in_right, settings);
  }
  return view;
}
}  // namespace mrpt_ext
