#include "mrpt_ext/simulation/map_generator.h"

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/simulation/rounding.h"

namespace mrpt_ext
{
namespace
{
std::vector<Vector3d> randomPositions(const MapPlan& plan, RandomStream& random)
{
  constexpr int kAttempts = 10000;  // per landmark, before the box counts as full
  std::vector<Vector3d> positions;
  for (int i = 0; i < plan.count; ++i)
  {
    const auto tooNear = [&](const Vector3d& p)
    {
      return std::any_of(positions.begin(), positions.end(),
                         [&](const Vector3d& q) { return (p - q).head<2>().norm() < plan.min_distance; });
    };
    Vector3d position;
    int attempts = 0;
    do {
      if (++attempts > kAttempts)
        throw configurationError("map: no room for " + std::to_string(plan.count) + " landmarks at least " +
                                 std::to_string(plan.min_distance) +
                                 " m apart, expected a larger box or fewer landmarks");
      for (int axis = 0; axis < 3; ++axis) position[axis] = random.uniform(plan.low[axis], plan.high[axis]);
    } while (tooNear(position));
    positions.push_back(position);
  }
  return positions;
}

std::vector<Vector3d> gridPositions(const MapPlan& plan)
{
  const auto along = [](double low, double high, int index, int count)
  { return count > 1 ? low + (high - low) * index / (count - 1) : 0.5 * (low + high); };
  std::vector<Vector3d> positions;
  for (int row = 0; row < plan.rows; ++row)
    for (int column = 0; column < plan.columns; ++column)
      positions.emplace_back(along(plan.low.x(), plan.high.x(), column, plan.columns),
                             along(plan.low.y(), plan.high.y(), row, plan.rows), plan.low.z());
  return positions;
}
}  // namespace

LandmarkTable generateMap(const MapPlan& plan, RandomStream& random)
{
  std::vector<Landmark> landmarks = plan.landmarks;
  if (plan.layout != MapLayout::given)
  {
    landmarks.clear();
    for (const Vector3d& position :
         plan.layout == MapLayout::random ? randomPositions(plan, random) : gridPositions(plan))
    {
      Landmark landmark;
      landmark.position = position;
      if (plan.with_ids) landmark.id = static_cast<int>(landmarks.size()) + 1;
      if (!plan.categories.empty()) landmark.category = plan.categories[landmarks.size() % plan.categories.size()];
      landmarks.push_back(landmark);
    }
  }
  for (Landmark& landmark : landmarks)
    landmark.position = landmark.position.unaryExpr([](double v) { return rounded(v); });
  return LandmarkTable(std::move(landmarks));
}
}  // namespace mrpt_ext
