#include "mrpt_ext/relocalization/grid_search.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTruncation = 3;  // standard deviations at which the misfit of a bearing is truncated
constexpr double kMostCells = 2e7;
constexpr double kCostOfRay = 0.5, kCostOfCell = 10;  // operations
constexpr double kMaxWork = 4e8;                      // bearings x landmarks x cells
constexpr double kCellRange = 3;                      // [m] converts the side of a cell into an angle
constexpr float kBehind = 1e12F;                      // squared tangent for landmarks behind the ray
constexpr double kSpreadOfCell = 0.5;  // of its side, as a standard deviation: above the uniform 0.29, for curvature

/// A bearing for one heading of the robot: origin relative to the robot and direction, in the axes of the map.
struct Ray
{
  float x, y, cosine, sine;
  float information;  // 1 / variance
};

/// Subtracts from `score`, for every cell of a row that begins at (x0, y), the misfit of a ray: half its squared
/// normalised distance from the nearest landmark, at most `max_misfit`.
MRPT_EXT_VECTOR_CLONES
void addRay(const Ray& ray, const float* landmark_x, const float* landmark_y, std::size_t landmarks, float x0, float y,
            float cell, float max_misfit, float* nearest, float* score, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i) nearest[i] = kBehind;
  for (std::size_t l = 0; l < landmarks; ++l)
  {
    const float dx = landmark_x[l] - ray.x - x0, dy = landmark_y[l] - ray.y - y;
    // Along and across the ray; tan of the angle between ray and landmark is across / along.
    const float along0 = dx * ray.cosine + dy * ray.sine, across0 = dy * ray.cosine - dx * ray.sine;
    const float along_per = -cell * ray.cosine, across_per = cell * ray.sine;
    MRPT_EXT_INDEPENDENT_ITERATIONS
    for (std::size_t i = 0; i < count; ++i)
    {
      const float k = static_cast<float>(i);
      const float along = along0 + k * along_per, across = across0 + k * across_per;
      const float square = along > 0.05F ? (across * across) / (along * along) : kBehind;
      nearest[i] = square < nearest[i] ? square : nearest[i];
    }
  }
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < count; ++i)
  {
    const float misfit = 0.5F * ray.information * nearest[i];
    score[i] -= misfit < max_misfit ? misfit : max_misfit;
  }
}

class Grid
{
 public:
  explicit Grid(const PoseRegion& region)
      : region_(region),
        columns_(cells(region.extent().x(), kGridCell)),
        rows_(cells(region.extent().y(), kGridCell)),
        turns_(cells(region.headingExtent(), kGridTurn)),
        scores_(columns_ * rows_ * turns_, 0.0F)
  {
  }

  [[nodiscard]] Pose2 pose(std::size_t i, std::size_t j, std::size_t t) const
  {
    const Vector2d side = cell();
    return {region_.low.x() + (static_cast<double>(i) + 0.5) * side.x(),
            region_.low.y() + (static_cast<double>(j) + 0.5) * side.y(),
            wrap(region_.phi_low + (static_cast<double>(t) + 0.5) * turn())};
  }
  [[nodiscard]] Vector2d cell() const
  {
    return {region_.extent().x() / static_cast<double>(columns_), region_.extent().y() / static_cast<double>(rows_)};
  }
  [[nodiscard]] double turn() const { return region_.headingExtent() / static_cast<double>(turns_); }

  /// False when it was stopped.
  [[nodiscard]] bool score(std::span<const WindowBearing> bearings, const LandmarkIndex& map, const WorkBudget& budget)
  {
    std::vector<float> nearest(columns_);
    const auto side = cell();
    const double cell_variance = square(kSpreadOfCell * turn()) + square(kSpreadOfCell * side.maxCoeff() / kCellRange);
    for (const WindowBearing& bearing : bearings)
    {
      std::vector<float> x, y;
      for (std::size_t l = 0; l < map.size(); ++l)
        if (map.mayShow(bearing.category, l))
        {
          x.push_back(static_cast<float>(map.position(l).x() - region_.low.x()));
          y.push_back(static_cast<float>(map.position(l).y() - region_.low.y()));
        }
      const double information = 1 / (square(bearing.std_bearing) + cell_variance);
      for (std::size_t t = 0; t < turns_; ++t)
      {
        if (budget.isStopped()) return false;
        const Pose2 sensor = compose({0, 0, pose(0, 0, t).phi}, bearing.T_robot_sensor);
        const double direction = sensor.phi + bearing.bearing;
        const Ray ray{static_cast<float>(sensor.x), static_cast<float>(sensor.y),
                      static_cast<float>(std::cos(direction)), static_cast<float>(std::sin(direction)),
                      static_cast<float>(information)};
        WorkCounter::add(static_cast<std::uint64_t>(kCostOfRay * static_cast<double>(rows_ * columns_ * x.size())));
        for (std::size_t j = 0; j < rows_; ++j)
          addRay(ray, x.data(), y.data(), x.size(), static_cast<float>(0.5 * side.x()),
                 static_cast<float>((static_cast<double>(j) + 0.5) * side.y()), static_cast<float>(side.x()),
                 static_cast<float>(0.5 * kTruncation * kTruncation), nearest.data(), scores_.data() + at(0, j, t),
                 columns_);
      }
    }
    return true;
  }

  /// Cells with no better neighbour, best first.
  [[nodiscard]] std::vector<GaussianPose> maxima() const
  {
    std::vector<std::pair<float, Pose2>> found;
    for (std::size_t t = 0; t < turns_; ++t)
      for (std::size_t j = 0; j < rows_; ++j)
        for (std::size_t i = 0; i < columns_; ++i)
          if (isMaximum(i, j, t)) found.emplace_back(scores_[at(i, j, t)], pose(i, j, t));
    const auto better = [](const auto& a, const auto& b) { return a.first > b.first; };
    std::stable_sort(found.begin(), found.end(), better);
    if (found.size() > kMostGridMaxima) found.resize(kMostGridMaxima);
    const Vector2d side = kSpreadOfCell * cell();
    const Matrix3d covariance = Vector3d(side.x(), side.y(), kSpreadOfCell * turn()).cwiseAbs2().asDiagonal();
    std::vector<GaussianPose> poses;
    for (const auto& [score, pose] : found) poses.push_back({pose, covariance});
    return poses;
  }

 private:
  static std::size_t cells(double extent, double side)
  {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(extent / side)));
  }
  [[nodiscard]] std::size_t at(std::size_t i, std::size_t j, std::size_t t) const
  {
    return (t * rows_ + j) * columns_ + i;
  }
  [[nodiscard]] bool isMaximum(std::size_t i, std::size_t j, std::size_t t) const
  {
    const std::size_t here = at(i, j, t);
    const bool full_circle = region_.headingExtent() >= kTwoPi;
    for (int a = -1; a <= 1; ++a)
    {
      if (!full_circle && ((a < 0 && t == 0) || (a > 0 && t + 1 == turns_))) continue;
      const std::size_t tt = (t + turns_ + static_cast<std::size_t>(a + 1) - 1) % turns_;
      for (std::size_t jj = j > 0 ? j - 1 : 0; jj <= std::min(j + 1, rows_ - 1); ++jj)
        for (std::size_t ii = i > 0 ? i - 1 : 0; ii <= std::min(i + 1, columns_ - 1); ++ii)
        {
          const std::size_t there = at(ii, jj, tt);
          if (scores_[there] > scores_[here] || (scores_[there] == scores_[here] && there < here)) return false;
        }
    }
    return true;
  }

  PoseRegion region_;
  std::size_t columns_, rows_, turns_;
  std::vector<float> scores_;
};
}  // namespace

std::vector<GaussianPose> gridMaxima(std::span<const WindowBearing> bearings, const LandmarkIndex& map,
                                     const PoseRegion& region, WorkBudget& budget)
{
  const Vector2d extent = region.extent();
  const double cells = extent.prod() / square(kGridCell) * region.headingExtent() / kGridTurn;
  const double work = cells * static_cast<double>(map.size() * bearings.size());
  if (bearings.empty() || work > kMaxWork || cells > kMostCells) return {};
  const auto cost = static_cast<std::uint64_t>(kCostOfRay * work + kCostOfCell * cells);
  if (cost > budget.left() || !budget.spend(cost)) return {};
  Grid grid(region);
  if (!grid.score(bearings, map, budget)) return {};
  return grid.maxima();
}
}  // namespace mrpt_ext
