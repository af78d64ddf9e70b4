#pragma once

namespace mrpt_ext
{
/// What is known beforehand about the mirror's rim in the image.
struct OutlineSettings
{
  double min_radius = 0.25, max_radius = 0.75;  ///< of the rim, as shares of the image's shorter side
  double min_aspect = 0.80, max_aspect = 1.25;  ///< width over height of the rim in the image (fx/fy)
  double min_visible_share = 0.4;               ///< of the rim's circumference that must be found
  double min_contrast = 5;                      ///< [grey levels] across the rim, in smoothed pixels
};
}  // namespace mrpt_ext
