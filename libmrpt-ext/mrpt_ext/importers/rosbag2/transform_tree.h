#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mrpt_ext/importers/rosbag2/ros_messages.h"

namespace mrpt_ext
{
/// The frames of a robot, as /tf and /tf_static tell them.
class TransformTree
{
 public:
  struct StampedTransform
  {
    double time = 0;  ///< [s]
    Pose3 pose;       ///< of the child in its parent
  };
  using Edge = std::pair<std::string, std::string>;  ///< parent and child

  void add(const RosPose& transform);
  /// Puts the transforms in order of time and finds those that change, before they are asked for.
  void finish();

  /// Pose of `frame` in `base` over transforms that never change, in either direction; nothing where no such way is.
  [[nodiscard]] std::optional<Pose3> fixedPose(const std::string& base, const std::string& frame) const;
  /// Transforms in order of time; empty where there are none.
  [[nodiscard]] const std::vector<StampedTransform>& transforms(const Edge& edge) const;
  /// Transforms that change.
  [[nodiscard]] const std::set<Edge>& movingEdges() const { return moving_; }
  [[nodiscard]] bool has(const std::string& frame) const { return neighbours_.count(frame) > 0; }

 private:
  /// Pose of b in a, over the one transform between them.
  [[nodiscard]] std::optional<Pose3> fixedStep(const std::string& a, const std::string& b) const;

  std::map<Edge, std::vector<StampedTransform>> edges_;
  std::map<std::string, std::set<std::string>> neighbours_;
  std::set<Edge> moving_;
};
}  // namespace mrpt_ext
