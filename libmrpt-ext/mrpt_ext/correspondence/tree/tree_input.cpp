#include "mrpt_ext/correspondence/tree/tree_input.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kRangeMargin = 1.3;  // a pose from few bearings may put its landmarks a little too far away

std::vector<int> landmarksOfKind(const LandmarkIndex& map, int kind)
{
  std::vector<int> landmarks;
  if (kind == kAnyCategory) return landmarks;  // empty: any
  for (std::size_t l = 0; l < map.size(); ++l)
    if (map.kind(l) == kind) landmarks.push_back(static_cast<int>(l));
  return landmarks;
}
}  // namespace

TreeInput scanWithMostBearings(const LandmarkIndex& map, std::span<const Scan> places)
{
  TreeInput fullest;
  for (const Scan& place : places)
  {
    TreeInput question{&place, {}, 0};
    for (const AnonymousDetection& d : place.detections)
    {
      if (!d.bearing || d.kind == kUnknownCategory) continue;
      question.bearings.push_back({*d.bearing, landmarksOfKind(map, d.kind)});
      question.std_bearing = std::max(question.std_bearing, d.std_bearing);
    }
    if (question.bearings.size() >= fullest.bearings.size()) fullest = std::move(question);
  }
  return fullest;
}

InterpretationOptions treeOptions(const TreeInput& question, const PoseSearchOptions& options)
{
  InterpretationOptions tree;
  tree.gate = InterpretationGate::covariance;
  tree.max_residual = options.gate * question.std_bearing;
  tree.std_bearing = question.std_bearing;
  if (question.place->model.max_range) tree.max_range = kRangeMargin * *question.place->model.max_range;
  tree.max_tested = std::min(options.max_tree_nodes, options.max_tested);
  if (options.area)
  {
    const double offset = question.place->T_robot_sensor.position().norm();
    tree.area = Box2{options.area->min.array() - offset, options.area->max.array() + offset};
  }
  return tree;
}

GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor)
{
  return compound(sensor, inverse(T_robot_sensor));
}
}  // namespace mrpt_ext
