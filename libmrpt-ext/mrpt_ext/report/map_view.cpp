#include "mrpt_ext/report/map_view.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "mrpt_ext/report/landmark_quality.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWidth = 720, kMinHeight = 240, kMaxHeight = 720;
constexpr double kMargin = 36;           // drawing units, room for names and the scale bar
constexpr double kSmallestExtent = 0.5;  // [m]
}  // namespace

MapView::MapView(const Vector2d& low, const Vector2d& high) : centre_(0.5 * (low + high)), width_(kWidth)
{
  const Vector2d extent = (high - low).cwiseMax(kSmallestExtent);
  scale_ = std::min((kWidth - 2 * kMargin) / extent.x(), (kMaxHeight - 2 * kMargin) / extent.y());
  height_ = std::clamp(extent.y() * scale_ + 2 * kMargin, kMinHeight, kMaxHeight);
}

std::vector<Landmark> shownLandmarks(const LandmarkTable& map, const std::map<std::string, LandmarkScore>& scores)
{
  const std::size_t stride = map.size() / kMostShownLandmarks + 1;
  std::vector<Landmark> shown;
  std::size_t i = 0;
  for (const Landmark& landmark : map.all())
  {
    const auto score = scores.find(std::to_string(landmark.id));
    const bool warned = score != scores.end() && !landmarkWarning(score->second).empty();
    if (i++ % stride == 0 || (warned && shown.size() < 2 * kMostShownLandmarks)) shown.push_back(landmark);
  }
  return shown;
}

Vector2d MapView::draw(const Vector2d& position) const
{
  const Vector2d offset = scale_ * (position - centre_);
  return {0.5 * width_ + offset.x(), 0.5 * height_ - offset.y()};
}

bool MapView::contains(const Vector2d& drawn) const
{
  return drawn.x() >= 0 && drawn.x() <= width_ && drawn.y() >= 0 && drawn.y() <= height_;
}

std::pair<Vector2d, Vector2d> mapExtent(const RunContext& context, const MethodTrajectory* path)
{
  Eigen::AlignedBox2d box;
  for (const Landmark& landmark : context.map.all()) box.extend(Vector2d(landmark.position.head<2>()));
  for (const TimedPose& truth : context.truth)
    if (truth.time >= context.start_time && truth.time <= context.start_time + context.duration_s)
      box.extend(truth.pose.position());
  if (path)
    for (const PoseEstimate& point : path->points) box.extend(point.pose.mean.position());
  if (box.isEmpty()) box.extend(Vector2d(0, 0));
  return {box.min(), box.max()};
}

MapView viewOf(const RunContext& context, const MethodTrajectory* path)
{
  const auto [low, high] = mapExtent(context, path);
  return {low, high};
}
}  // namespace mrpt_ext
