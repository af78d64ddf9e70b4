#pragma once

#include <Eigen/Core>
#include <vector>

#include "mrpt_ext/vision/slice_profile.h"

namespace mrpt_ext
{
/// Where an object is in one slice: from `offset` - `half_width` to `offset` + `half_width`, with edges that a Gaussian
/// of standard deviation `blur` has softened [px].
struct Outline
{
  double offset = 0, half_width = 0, blur = 1;
};

/// One slice's part of a least-squares problem for the outline, linearised: parameters are those of Outline in their
/// order; what else is unknown of the slice is eliminated.
struct OutlineEquations
{
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< for residuals of variance 1
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  std::vector<std::vector<double>> residuals;  ///< [grey levels] of the samples of each channel
  double slopes = 0;                           ///< sum of the squared derivatives of the samples by `offset`
  double slope_squares = 0;  ///< sum of the squared residuals, weighted by these: residuals at the edges

  [[nodiscard]] double meanSquare() const;
};

/// By colour: a sample's chroma is its brightness times that of the object inside and of the background outside, two
/// unknowns per channel. What shading and shadows do is in the brightness, as it is measured; at the edge, where it is
/// a mixture, it is that of the nearest sample clear of the edge.
[[nodiscard]] OutlineEquations colourEquations(const SliceProfile& profile, const Outline& outline);

/// The same with a background of its own on either side: what hides a part of the object is of another colour.
[[nodiscard]] OutlineEquations colourEquationsOfSides(const SliceProfile& profile, const Outline& outline);

/// By brightness: a step at either edge, from unknown levels beside the object to one that changes across it like the
/// shade of a round body, as a parabola.
[[nodiscard]] OutlineEquations brightnessEquations(const SliceProfile& profile, const Outline& outline);
}  // namespace mrpt_ext
