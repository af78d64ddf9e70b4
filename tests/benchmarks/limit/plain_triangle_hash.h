#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// The plain form of a search for points: triangles of ten nearest neighbours under their rounded side lengths, the
/// first pose that explains three quarters of the points. One tolerance for everything.
class PlainTriangleHash
{
 public:
  PlainTriangleHash(const std::vector<Vector2d>& landmarks, const Vector2d& low, double bin);
  [[nodiscard]] std::optional<Pose2> find(const std::vector<Vector2d>& points, double tolerance) const;

 private:
  struct Corners
  {
    int a, b, c;
  };
  [[nodiscard]] std::vector<int> near(const Vector2d& at, double radius) const;
  [[nodiscard]] int explained(const std::vector<Vector2d>& points, const Pose2& pose, double tolerance) const;
  [[nodiscard]] static std::uint64_t key(int a, int b, int c);

  std::vector<Vector2d> landmarks_;
  Vector2d low_;
  double bin_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;  // of 4 m
  std::unordered_map<std::uint64_t, std::vector<Corners>> triangles_;
};
}  // namespace mrpt_ext
