#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/hyperbolic_mirror.h"
#include "mrpt_ext/vision/mirror_panorama.h"
#include "mrpt_ext/vision/object_colours.h"

namespace mrpt_ext
{
/// Sizes of what stands on the field of paper 001 [m]. A pole is an upright cylinder with three bands of equal height.
struct FieldObjectSizes
{
  double pole_radius = 0, pole_height = 0, ball_radius = 0;
};

/// Search for poles and balls.
struct FieldObjectSearch
{
  double min_distance = 0.3, max_distance = 10;  ///< [m]
  double band_share = 0.5;                       ///< of a band's pixels that must have its colour
  double width_tolerance = 0.35;  ///< how far the seen width may differ from that of the object's distance, share
  double min_area = 6;            ///< [pixels of the panorama] of a ball
};

/// Roughly where something is, to be measured by its silhouette.
struct ObjectGuess
{
  double azimuth = 0;     ///< [rad] in the image
  double half_width = 0;  ///< [rad]
  double distance = 0;    ///< [m] from the mirror's axis
};

/// Half the angle under which a pole appears.
[[nodiscard]] double poleHalfWidth(const FieldObjectSizes& sizes, double distance);

/// How many pixels of one colour each column of a panorama has above each row.
using ColourCounts = cv::Mat_<short>;
[[nodiscard]] ColourCounts countColour(const cv::Mat1b& colours, ObjectColour colour);

/// The pole whose bands are from above of the colours `ends`, `middle`, `ends`: for every azimuth the distance that
/// explains the colours along it best. Two of the three bands are enough, one of them the middle one; the others may be
/// hidden or outside the mirror. Nothing when bands and width fit one distance nowhere.
[[nodiscard]] std::optional<ObjectGuess> findBandedPole(const ColourCounts& ends, const ColourCounts& middle,
                                                        const MirrorPanorama& panorama, const HyperbolicMirror& mirror,
                                                        const FieldObjectSizes& sizes, const FieldObjectSearch& search);

/// Where the ball may be: orange patches on the floor as large as a ball at the distance where it touches the floor,
/// the largest first.
[[nodiscard]] std::vector<ObjectGuess> findBalls(const cv::Mat1b& colours, const MirrorPanorama& panorama,
                                                 const HyperbolicMirror& mirror, const FieldObjectSizes& sizes,
                                                 const FieldObjectSearch& search);
}  // namespace mrpt_ext
