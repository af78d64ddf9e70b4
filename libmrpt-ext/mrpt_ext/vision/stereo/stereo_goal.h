#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/vision/stereo/floor_junctions.h"
#include "mrpt_ext/vision/stereo/goal_corners.h"

namespace mrpt_ext
{
/// The narrow stereo pair of paper 004, section 4.
struct StereoGoalSettings
{
  StereoCamera camera;
  bool with_corners = true, with_lines = true;
  GoalCornerSettings corners;
  MarkingSettings markings;
};

/// A junction of markings seen in both images.
struct LineLandmark
{
  JunctionKind kind = JunctionKind::corner;
  cv::Point2d left, right;  ///< [px]
  StereoMeasurement measured;
};

/// What a pair of images shows.
struct StereoGoalView
{
  std::string problem;  ///< why there is no measurement; empty when there may be some
  std::vector<GoalCorner> corners;
  std::vector<LineLandmark> landmarks;
  FloorMarkings markings;  ///< of the left image
};

/// Junctions of both images' markings that are of one kind, are in the same row and whose disparity agrees with the
/// floor's.
[[nodiscard]] std::vector<LineLandmark> findLineLandmarks(const FloorMarkings& left, const FloorMarkings& right,
                                                          const StereoGoalSettings& settings);

/// Goal corners and line landmarks. A wrong, empty or black image on either side is a problem, and nothing is measured.
[[nodiscard]] StereoGoalView viewStereoGoal(const cv::Mat& left, const cv::Mat& right,
                                            const StereoGoalSettings& settings);

/// The left image in colour with what was found.
[[nodiscard]] cv::Mat drawStereoGoal(const cv::Mat& left, const StereoGoalView& view,
                                     const StereoGoalSettings& settings);
}  // namespace mrpt_ext
