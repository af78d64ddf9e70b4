#pragma once

#include <Eigen/Core>
#include <vector>

#include "mrpt_ext/vision/slice_profile.h"

namespace mrpt_ext
{
/// Where an object is in one slice: from `offset` - `half_width` to `offset` + `half_width`, with edges that a Gaussian
/// of standard deviation `blur` has softened [px]; and how its brightness changes across it, by the shares `tilt` t -
/// `bulge` t^2 with t = -1 and 1 at the edges.
struct Outline
{
  double offset = 0, half_width = 0, blur = 1;
  double tilt = 0, bulge = 0;
};

constexpr int kOutlineParameters = 5;
using OutlineVector = Eigen::Matrix<double, kOutlineParameters, 1>;
using OutlineMatrix = Eigen::Matrix<double, kOutlineParameters, kOutlineParameters>;

/// One slice's part of a least-squares problem for the outline, linearised: parameters are those of Outline in their
/// order; what else is unknown of the slice is eliminated.
struct OutlineEquations
{
  OutlineMatrix information = OutlineMatrix::Zero();  ///< for residuals of variance 1
  OutlineVector gradient = OutlineVector::Zero();
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

/// By brightness: a step at either edge, from unknown levels beside the object to an unknown level that changes across
/// it like the shade of a round body, as a parabola. All slices of an object have the same shade: in each alone a
/// narrow object that is darker on one side is hardly to be told from one that is farther on the other.
[[nodiscard]] OutlineEquations brightnessEquations(const SliceProfile& profile, const Outline& outline);
}  // namespace mrpt_ext
