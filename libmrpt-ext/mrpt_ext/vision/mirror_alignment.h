#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/mirror_axis.h"
#include "mrpt_ext/vision/radial_edge.h"

namespace mrpt_ext
{
/// One image, as its alignment sees it.
struct AlignmentView
{
  AxisEllipse rim;
  std::vector<RadialEdge> edges;  ///< azimuths about the axis that is to be improved
};

/// What is known beforehand, as standard deviations about zero.
struct AlignmentPriors
{
  double offset = 0.03;         ///< of the mirror, share of the rim's radius
  double camera_tilt = 0.02;    ///< [rad]
  double vertical_tilt = 0.02;  ///< [rad]
  double principal_point = 0;   ///< of the stated one, share of the rim's radius; 0: none is stated
};

/// Which axes make the edges of a sequence straightest.
struct MirrorAlignment
{
  MirrorAxis axis;
  Eigen::Matrix<double, 6, 6> covariance;  ///< of offset (shares of the rim's radius), camera tilt, vertical tilt [rad]
  Eigen::Vector2d offset;                  ///< of the mirror, shares of the rim's radius
  double std_usual = 0;                    ///< [rad] of azimuths, where the mirror's shape was not stated
  std::size_t edges = 0;                   ///< that were compared
  double bend_before = 0, bend_after = 0;  ///< [rad] median distance of the parts of edges from straight ones
  double straight_parts = 0;   ///< number of parts that fit straight edges, those that fit less well for less
  double straight_before = 0;  ///< the same about the axes it started from

  /// Whether it straightens edges, or shows more of them, than what it started from: by more than few edges do by
  /// chance.
  [[nodiscard]] bool isBetter() const;
  /// [rad] standard deviation that the alignment leaves to the azimuth of an edge, mean over the turn, at a radius.
  [[nodiscard]] double stdAzimuth(double share) const;
};

/// Offset of the mirror, tilt of the camera under it and tilt of both, from the parts of edges: with wrong axes those
/// of one edge are at different azimuths. Linear least squares about `start`, reweighted (Tukey), every edge with an
/// unknown azimuth of its own. Without a stated principal point `start.principal_point` is that of the first view's
/// rim. Nothing when too few edges can be compared.
[[nodiscard]] std::optional<MirrorAlignment> alignMirror(const std::vector<AlignmentView>& views,
                                                         const MirrorAxis& start, const AlignmentPriors& priors);
}  // namespace mrpt_ext
