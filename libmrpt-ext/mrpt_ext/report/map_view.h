#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// A page holds no more landmarks than can be told apart.
inline constexpr std::size_t kMostShownLandmarks = 5000;

/// All landmarks of a map; of a larger one every n-th, and those with a warning.
[[nodiscard]] std::vector<Landmark> shownLandmarks(const LandmarkTable& map,
                                                   const std::map<std::string, LandmarkScore>& scores);

/// From map coordinates [m], y upwards, to drawing units, y downwards, with equal scale on both axes.
class MapView
{
 public:
  /// Shows the box from `low` to `high` with some space around it.
  MapView(const Vector2d& low, const Vector2d& high);

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double scale() const { return scale_; }  ///< drawing units per metre
  [[nodiscard]] Vector2d draw(const Vector2d& position) const;
  [[nodiscard]] bool contains(const Vector2d& drawn) const;

 private:
  Vector2d centre_;
  double width_ = 0, height_ = 0, scale_ = 1;
};

/// Corners {low, high} of the box around landmarks, truth within the log, and `path` (may be null) [m]; the origin when
/// there is nothing.
[[nodiscard]] std::pair<Vector2d, Vector2d> mapExtent(const RunContext& context, const MethodTrajectory* path);
/// View of landmarks, truth within the log, and `path` (may be null); around the origin when there is nothing.
[[nodiscard]] MapView viewOf(const RunContext& context, const MethodTrajectory* path);
}  // namespace mrpt_ext
