#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/tree/circle_inversion.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A landmark and where its ray crosses another.
struct CrossedLandmark
{
  std::size_t landmark = 0;
  RayCrossing crossing;
};

/// The rays of every bearing to every landmark, seen from one reference landmark, and the vector loops over them.
/// Arrays are padded to whole vectors with landmarks that are in no mask.
class RayBundle
{
 public:
  /// A set of landmarks: an entry per landmark (and padding), -1 for a member, 0 otherwise.
  using Mask = std::vector<std::int64_t>;

  /// `units`: (cos b, sin b) of every bearing. `error`: see CrossingBounds.
  RayBundle(std::span<const Vector2d> landmarks, std::vector<Vector2d> units, double error);

  /// Chooses the reference: the landmark that is matched to this bearing.
  void setReference(std::size_t bearing, std::size_t landmark);

  [[nodiscard]] std::size_t size() const { return x_.size(); }  ///< landmarks and padding
  [[nodiscard]] const Vector2d& unit(std::size_t bearing) const { return units_[bearing]; }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] InverseRay ray(std::size_t bearing, std::size_t landmark) const
  {
    const Directions& d = directions_[bearing];
    return {px_[landmark], py_[landmark], d.ux[landmark], d.uy[landmark]};
  }

  /// The landmarks of the mask whose rays for `bearing` may cross `ray`.
  void cross(const InverseRay& ray, std::size_t bearing, const CrossingBounds& bounds, const Mask& mask,
             std::vector<CrossedLandmark>& result);

  /// Computes the gates of all landmarks from a crossing. Those farther than `max_range` [m] from every position
  /// that the crossing allows get none.
  void openGates(const RayCrossing& crossing, bool covariance, double max_range);
  /// Closes the gate of a landmark, whatever the direction: NaN compares false.
  void closeGate(std::size_t landmark) { narrow_[landmark] = std::numeric_limits<double>::quiet_NaN(); }

  /// The landmarks of the mask whose gates admit the bearing.
  void admit(std::size_t bearing, const Mask& mask, std::vector<std::size_t>& result);

 private:
  struct Directions
  {
    std::vector<double> ux, uy;
  };

  std::vector<Vector2d> units_;
  double error_;
  std::vector<double> x_, y_;  // landmarks [m]
  double reference_x_ = 0, reference_y_ = 0;
  std::vector<double> px_, py_;                  // landmarks in the inverse plane
  std::vector<double> qx_, qy_;                  // their rays for the bearing of the reference itself
  std::vector<Directions> directions_;           // per bearing
  std::vector<double> wx_, wy_, narrow_, wide_;  // gates
  std::vector<double> crossings_;                // results of a loop
  Mask marks_;
};
}  // namespace mrpt_ext
