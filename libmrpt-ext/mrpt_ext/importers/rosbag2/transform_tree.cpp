#include "mrpt_ext/importers/rosbag2/transform_tree.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kSame = 1e-6;  ///< [m], [rad]

bool isSame(const Pose3& a, const Pose3& b)
{
  return (a.position - b.position).norm() < kSame && (a.rotation - b.rotation).norm() < kSame;
}
}  // namespace

void TransformTree::add(const RosPose& transform)
{
  const Edge edge{transform.header.frame, transform.child_frame};
  std::vector<StampedTransform>& known = edges_[edge];
  const StampedTransform added{transform.header.time, transform.pose};
  // Of transforms that repeat themselves the first and the last are enough.
  const std::size_t size = known.size();
  const bool repeats = size >= 2 && isSame(known[size - 2].pose, added.pose) &&
                       isSame(known[size - 1].pose, added.pose) && known.back().time <= added.time;
  if (repeats)
    known.back() = added;
  else
    known.push_back(added);
  neighbours_[edge.first].insert(edge.second);
  neighbours_[edge.second].insert(edge.first);
}

void TransformTree::finish()
{
  for (auto& [edge, transforms] : edges_)
  {
    std::stable_sort(transforms.begin(), transforms.end(),
                     [](const StampedTransform& a, const StampedTransform& b) { return a.time < b.time; });
    const Pose3& first = transforms.front().pose;
    if (std::any_of(transforms.begin(), transforms.end(), [&](const auto& one) { return !isSame(one.pose, first); }))
      moving_.insert(edge);
  }
}

std::optional<Pose3> TransformTree::fixedStep(const std::string& a, const std::string& b) const
{
  const auto down = edges_.find({a, b});
  if (down != edges_.end())
    return moving_.count(down->first) > 0 ? std::nullopt : std::optional(down->second.front().pose);
  const auto up = edges_.find({b, a});
  if (up == edges_.end() || moving_.count(up->first) > 0) return std::nullopt;
  return up->second.front().pose.inverse();
}

std::optional<Pose3> TransformTree::fixedPose(const std::string& base, const std::string& frame) const
{
  std::map<std::string, Pose3> reached{{base, {}}};
  for (std::vector<std::string> open{base}; !open.empty();)
  {
    const std::string from = open.back();
    open.pop_back();
    const auto neighbours = neighbours_.find(from);
    if (neighbours == neighbours_.end()) continue;
    for (const std::string& to : neighbours->second)
    {
      if (reached.count(to) > 0) continue;
      const auto step = fixedStep(from, to);
      if (!step) continue;
      reached[to] = reached[from] * *step;
      open.push_back(to);
    }
  }
  const auto found = reached.find(frame);
  return found == reached.end() ? std::nullopt : std::optional(found->second);
}

const std::vector<TransformTree::StampedTransform>& TransformTree::transforms(const Edge& edge) const
{
  static const std::vector<StampedTransform> kNone;
  const auto found = edges_.find(edge);
  return found == edges_.end() ? kNone : found->second;
}
}  // namespace mrpt_ext
