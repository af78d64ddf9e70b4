#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/stereo/goal_corners.h"

namespace mrpt_ext
{
/// What a corner tells beside its place, and what must be the same in all frames, whoever moves.
struct CornerEvidence
{
  int colour = 0;
  std::optional<double> foot;   ///< [px] rows that its foot is below where the floor is at its disparity
  double std_foot = 0;          ///< [px] by the disparity
  double foot_by_pitch = 0;     ///< [px/rad] rows by which the expected foot moves
  double foot_by_height = 0;    ///< [px/m]
  std::optional<double> right;  ///< [px] rows that the right image shows it lower
  StereoMeasurement measured;
};

/// `right` by least squares over the rows around the corner's place in both images, up to four rows. Nothing of a foot
/// below the image, nor where the images show no rows to compare. Images are BGR.
[[nodiscard]] CornerEvidence evidenceOf(const GoalCorner& corner, const cv::Mat& left, const cv::Mat& right,
                                        const StereoCamera& camera);

/// A constant over frames.
struct CornerConstant
{
  double value = 0;    ///< median
  double scatter = 0;  ///< standard deviation of one corner's, by the median deviation
  int count = 0;
  [[nodiscard]] double std() const;
};

/// The constants; nothing where too few corners tell. A wrong pitch moves all feet alike, a wrong height near ones
/// more: that of both is there that leaves less scatter.
struct CornerConstants
{
  std::optional<CornerConstant> pitch;       ///< [rad] to be added to the camera's
  std::optional<CornerConstant> height;      ///< [m] likewise
  std::optional<CornerConstant> stated;      ///< [px] of the feet as the camera is stated
  std::optional<CornerConstant> foot;        ///< [px] what is left of the feet when it is corrected
  std::optional<CornerConstant> right;       ///< [px]
  std::optional<CornerConstant> goal_width;  ///< [m] between both corners of a goal
};

[[nodiscard]] CornerConstants constantsOf(const std::vector<std::vector<CornerEvidence>>& frames);

/// Which corners of a frame agree with the constants: foot and row of the right image within `gate` standard deviations
/// of stated errors and scatter, and both corners of a goal as far apart as it is wide. Where that is not so, neither
/// of the two agrees.
[[nodiscard]] std::vector<bool> agreeingCorners(const std::vector<CornerEvidence>& frame,
                                                const CornerConstants& constants);
}  // namespace mrpt_ext
