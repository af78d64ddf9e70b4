#include "mrpt_ext/correspondence/tree/tree_input.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kTreeRangeMargin = 1.3;  // a pose from few bearings may put its landmarks a little too far away

std::vector<int> landmarksOfCategory(const LandmarkIndex& map, int category)
{
  std::vector<int> landmarks;
  if (category == kAnyCategory) return landmarks;  // empty: any
  for (std::size_t l = 0; l < map.size(); ++l)
    if (map.category(l) == category) landmarks.push_back(static_cast<int>(l));
  return landmarks;
}
}  // namespace

TreeInput scanWithMostBearings(const LandmarkIndex& map, std::span<const Scan> scans)
{
  TreeInput most;
  for (const Scan& scan : scans)
  {
    TreeInput input{&scan, {}, 0};
    for (const AnonymousDetection& d : scan.detections)
    {
      if (!d.bearing || d.category == kUnknownCategory) continue;
      input.bearings.push_back({*d.bearing, landmarksOfCategory(map, d.category)});
      input.std_bearing = std::max(input.std_bearing, d.std_bearing);
    }
    if (input.bearings.size() >= most.bearings.size()) most = std::move(input);
  }
  return most;
}

InterpretationOptions treeOptions(const TreeInput& input, const PoseSearchOptions& options)
{
  InterpretationOptions tree;
  tree.gate = InterpretationGate::covariance;
  tree.max_residual = options.gate * input.std_bearing;
  tree.std_bearing = input.std_bearing;
  if (input.scan->model.max_range) tree.max_range = kTreeRangeMargin * *input.scan->model.max_range;
  tree.max_tested = options.max_tree_nodes;
  tree.budget = options.budget;
  if (options.area)
  {
    const double offset = input.scan->T_robot_sensor.position().norm();
    tree.area = Box2{options.area->min.array() - offset, options.area->max.array() + offset};
  }
  return tree;
}

GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor)
{
  return compound(sensor, inverse(T_robot_sensor));
}
}  // namespace mrpt_ext
