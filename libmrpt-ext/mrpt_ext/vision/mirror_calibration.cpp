#include "mrpt_ext/vision/mirror_calibration.h"

#include <cmath>
#include <utility>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kRounds = 5;
constexpr double kStatedPrincipalPoint = 0.0005;  ///< standard deviation, share of the rim's radius: a tenth of a pixel
constexpr double kUsualDeviation = 0.04;          ///< of azimuths by the unknown mirror, per offset of it
constexpr double kNoOffset = 0.0005;              ///< standard deviation of what is taken for right
constexpr double kNoTilt = 0.0003;                ///< [rad] likewise

std::vector<AlignmentView> viewsAbout(const std::vector<cv::Mat>& images, ConicMirrorSettings settings,
                                      const std::optional<MirrorAxis>& axis)
{
  settings.axis = axis;
  std::vector<AlignmentView> views;
  for (const cv::Mat& image : images)
    if (ConicMirrorView view = viewConicMirror(image, settings); view.outline)
      views.push_back({view.outline->rim, std::move(view.edges)});
  return views;
}

/// Where to start from and what may be wrong there.
struct Hypothesis
{
  MirrorAxis start;
  AlignmentPriors priors;
};

std::optional<MirrorAlignment> alignedFrom(const std::vector<cv::Mat>& images, const ConicMirrorSettings& settings,
                                           const Hypothesis& hypothesis)
{
  std::optional<MirrorAlignment> best;
  MirrorAxis axis = hypothesis.start;
  for (int round = 0; round < kRounds; ++round)
  {
    auto alignment = alignMirror(viewsAbout(images, settings, axis), axis, hypothesis.priors);
    if (!alignment) break;
    axis = alignment->axis;
    if (!best || alignment->straight_parts > best->straight_parts) best = std::move(alignment);
  }
  return best;
}

/// What the rim is beside the principal point comes from the mirror's offset, or from a tilt of the camera.
std::vector<Hypothesis> aboutStatedAxis(const MirrorAxis& stated, const AxisEllipse& rim)
{
  AlignmentPriors priors;
  priors.principal_point = kStatedPrincipalPoint;
  MirrorAxis tilted = stated;
  const double slope = std::tan(stated.rim_angle);
  const cv::Point2d beside = mirrorOffset(rim, stated);
  tilted.camera_tilt += cv::Point2d(beside.x / rim.semi_u, beside.y / rim.semi_v) / (1 / slope + slope);
  return {{stated, priors}, {tilted, priors}};
}

/// Axes that agree.
MirrorAxis aligned(const AxisEllipse& rim) { return {rim.centre, kUsualCone, kUsualRim, {}, {}}; }

std::vector<Hypothesis> oneCauseEach(const AxisEllipse& rim)
{
  const MirrorAxis centred = aligned(rim);
  const AlignmentPriors any;
  return {{centred, {any.offset, kNoTilt, kNoTilt, 0}},
          {centred, {kNoOffset, any.camera_tilt, kNoTilt, 0}},
          {centred, {kNoOffset, kNoTilt, any.vertical_tilt, 0}}};
}
}  // namespace

std::optional<MirrorAlignment> calibrateMirror(const std::vector<cv::Mat>& images, const ConicMirrorSettings& settings)
{
  const auto views = viewsAbout(images, settings, settings.axis);
  if (views.empty()) return std::nullopt;
  std::optional<MirrorAlignment> best;
  for (const Hypothesis& hypothesis :
       settings.axis ? aboutStatedAxis(*settings.axis, views.front().rim) : oneCauseEach(views.front().rim))
    if (auto alignment = alignedFrom(images, settings, hypothesis);
        alignment && (!best || alignment->straight_parts > best->straight_parts))
      best = std::move(alignment);
  const auto before = alignMirror(views, settings.axis.value_or(aligned(views.front().rim)), {});
  if (best) best->bend_before = before ? before->bend_before : kPi;
  if (best && !settings.axis) best->std_usual = kUsualDeviation * std::hypot(best->offset.x(), best->offset.y());
  if (best) best->straight_before = before ? before->straight_before : 0;
  return best;
}
}  // namespace mrpt_ext
