#include "mrpt_ext/geometry/landmark_table.h"

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
LandmarkTable::LandmarkTable(std::vector<Landmark> landmarks) : landmarks_(std::move(landmarks))
{
  for (std::size_t i = 0; i < landmarks_.size(); ++i)
  {
    const Landmark& landmark = landmarks_[i];
    if (!landmark.position.allFinite() || !landmark.stddev.allFinite())
      throw configurationError("landmark " + std::to_string(i + 1) + ": coordinates must be finite numbers");
    if (!std::isfinite(landmark.yaw.value_or(0)) || !std::isfinite(landmark.std_yaw))
      throw configurationError("landmark " + std::to_string(i + 1) + ": its direction must be a finite number");
    mean_height_ += landmark.position.z() / static_cast<double>(landmarks_.size());
    if (landmark.id != kNoId) index_by_id_.emplace_back(landmark.id, i);
  }
  std::sort(index_by_id_.begin(), index_by_id_.end());
  const auto twin = std::adjacent_find(index_by_id_.begin(), index_by_id_.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twin != index_by_id_.end())
    throw configurationError("landmark id " + std::to_string(twin->first) + " occurs twice, ids must be unique");
}

std::optional<std::size_t> LandmarkTable::indexOf(int id) const
{
  if (id == kNoId) return std::nullopt;
  const auto found = std::lower_bound(index_by_id_.begin(), index_by_id_.end(), id,
                                      [](const auto& entry, int wanted) { return entry.first < wanted; });
  if (found == index_by_id_.end() || found->first != id) return std::nullopt;
  return found->second;
}

std::pair<Vector2d, Vector2d> LandmarkTable::boundingBox() const
{
  if (landmarks_.empty()) return {Vector2d::Zero(), Vector2d::Zero()};
  Vector2d low = landmarks_.front().position.head<2>(), high = low;
  for (const Landmark& landmark : landmarks_)
  {
    low = low.cwiseMin(landmark.position.head<2>());
    high = high.cwiseMax(landmark.position.head<2>());
  }
  return {low, high};
}
}  // namespace mrpt_ext
