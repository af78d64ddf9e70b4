#pragma once

#include <array>
#include <vector>

namespace mrpt_ext
{
/// The interpretation tree as one would write it down first, made fast: the yardstick of `search/tree_*`. Paper 000,
/// section 3: depth 3 solves the pose of every ordered triple in closed form, deeper a landmark is compared with the
/// bearing by the pose of its prefix, which is solved anew after each match. Bearings in the order given, one gate, no
/// area, no look at what is still to come: it may lose the truth under noise.
class PlainTree
{
 public:
  struct Point
  {
    double x = 0, y = 0;
  };

  PlainTree(std::vector<Point> landmarks, const std::vector<double>& bearings, double gate);

  /// Number of complete assignments.
  int search();
  /// True if one of them gave every bearing the landmark of the same number.
  [[nodiscard]] bool foundInOrder() const { return found_in_order_; }

 private:
  /// Heading as a unit vector.
  struct Pose
  {
    double x = 0, y = 0, c = 1, s = 0;
  };

  void extend(std::size_t depth, const Pose& prefix);
  bool solve(std::size_t matched, Pose& pose) const;

  std::vector<Point> landmarks_, units_;
  double tangent2_;
  std::vector<std::size_t> path_;
  std::vector<char> used_;
  int solutions_ = 0;
  bool found_in_order_ = false;
};
}  // namespace mrpt_ext
