#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Many robot poses at once, as a structure of arrays of equal length: x, y [m] from `origin`, phi [rad].
/// Single precision is to 1e-7 of the distance from the origin, which is therefore put near the robot (the centre of
/// the map): 10 micrometres at 100 m. Each pose may carry systematic errors of its own, one column per state.
struct PoseBatch
{
  Vector2d origin{0, 0};  ///< [m] in the map frame
  std::span<const float> x, y, phi;
  std::span<const BiasState> bias_states;
  std::vector<std::span<const float>> bias;  ///< in the order of bias_states

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// In the map frame, heading wrapped.
  [[nodiscard]] Pose2 operator[](std::size_t i) const
  {
    return {origin.x() + double{x[i]}, origin.y() + double{y[i]}, wrap(double{phi[i]})};
  }
  /// The `count` poses from `first` on.
  [[nodiscard]] PoseBatch block(std::size_t first, std::size_t count) const
  {
    PoseBatch part{origin, x.subspan(first, count), y.subspan(first, count), phi.subspan(first, count), bias_states};
    for (const auto& column : bias) part.bias.push_back(column.subspan(first, count));
    return part;
  }
};

/// Owns the columns of a PoseBatch.
struct PoseColumns
{
  explicit PoseColumns(const Vector2d& batch_origin = {0, 0}) : origin(batch_origin) {}

  Vector2d origin;
  std::vector<float> x, y, phi;

  void add(const Pose2& pose)
  {
    x.push_back(static_cast<float>(pose.x - origin.x()));
    y.push_back(static_cast<float>(pose.y - origin.y()));
    phi.push_back(static_cast<float>(pose.phi));
  }
  [[nodiscard]] PoseBatch batch() const { return {.origin = origin, .x = x, .y = y, .phi = phi, .bias_states = {}}; }
};
}  // namespace mrpt_ext
