#pragma once

#include <array>
#include <string>
#include <vector>

#include "mrpt_ext/vision/stereo/goal_colour.h"
#include "mrpt_ext/vision/stereo/stereo_camera.h"

namespace mrpt_ext
{
/// When a step from white to a goal's colour is the corner of a goal.
struct GoalCornerSettings
{
  std::array<GoalColour, 2> colours{GoalColour({0.22F, 0.9F, 1.F}), GoalColour({0.85F, 0.37F, 0.22F})};
  int scan_step = 4;               ///< [px] every fourth pixel of every fourth row
  double goal_height = 0.05;       ///< [m]
  double goal_depth = 0.15;        ///< [m]
  double height_tolerance = 0.25;  ///< share of the goal's height in the image
  double min_range = 0.15;         ///< [m] depth
  double max_range = 2.2;          ///< [m] depth
  int min_rows = 5;                ///< rows in which both images must show the step
  double std_column = 0.15;        ///< [px] of a corner's column beyond the scatter of the rows: coding, blur
  double std_disparity = 0.08;     ///< [px] likewise; both images share much of the former
};

/// Where the white wall and a goal meet, seen in both images.
struct GoalCorner
{
  int colour = 0;                  ///< index into GoalCornerSettings::colours
  int side = 0;                    ///< +1: the goal is to the right, so it is the left corner as seen from the field
  double u_left = 0, u_right = 0;  ///< [px] at the corner's foot
  double row_top = 0, row_bottom = 0;  ///< [px] of the coloured side
  double white_bottom = 0;             ///< [px] of the white side
  StereoMeasurement measured;
  double side_width = 0;  ///< [px] columns of the goal's own side, where that is white and seen
};

/// A pixel where the coarse scan found white beside a goal's colour.
struct CornerCandidate
{
  int colour = 0, side = 0;
  double column = 0;
  int first_row = 0, last_row = 0;
};

/// The scan over every `step`-th pixel of every `step`-th row.
[[nodiscard]] std::vector<CornerCandidate> scanForGoals(const cv::Mat& bgr, const GoalCornerSettings& settings);

/// Corners of goals by paper 004: a coarse scan, the step searched for at full scale around it row by row, outliers
/// over the rows removed, the same step in the right image. A robot in the goal's colour in front of a white wall is
/// not as high as a goal where it stands, and its foot is below the wall's: it is left out; so are both of two that
/// would be the same corner, and a corner whose white side is too narrow to be seen, as the goal's other side tells.
/// Images are BGR of equal size.
[[nodiscard]] std::vector<GoalCorner> findGoalCorners(const cv::Mat& left, const cv::Mat& right,
                                                      const StereoCamera& camera, const GoalCornerSettings& settings);
}  // namespace mrpt_ext
