#pragma once

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// The field of paper 001: pole p (left) at (-half_width, depth), pole q (right) at (half_width, depth) in the world.
struct PoleField
{
  double half_width = 0;  ///< Fw, > 0
  double depth = 0;       ///< Fd
};

/// Pose from two poles, in the paper's frames (see movis_frame.h) and the unit of the input.
struct TwoPolePose
{
  SolveStatus status = SolveStatus::bad_input;
  double beta = 0;            ///< slope of the robot's x axis in the world [rad]
  Vector2d turned_q{0, 0};    ///< the paper's (X_r, Y_r) by the right pole: position in axes turned with the robot
  Vector2d turned_p{0, 0};    ///< the same by the left pole
  Vector2d world_q{0, 0};     ///< robot position in the world by the right pole: Rot(beta) turned_q
  Vector2d world_p{0, 0};     ///< by the left pole
  Vector2d world_mean{0, 0};  ///< mean of both: errors no longer depend on which pole is nearer
  double misfit = 0;          ///< |q - p| - 2 Fw: two poles measure one length too many
};

/// Slope and position from the poles seen at `p` and `q` in the robot frame (paper 001, eq 3-7).
/// Deviations: atan2 in eq 5; eq 6-7 print p's coordinates with the signs that belong to q (an error of 2 Fw), both
/// correct forms are given here; the paper takes (X_r, Y_r) for world coordinates, which they are at beta = 0 only.
/// Status `degenerate`: both poles have the same position. No app uses it; two_landmark_pose.h is the general form.
[[nodiscard]] TwoPolePose solveTwoPolePose(const Vector2d& p, const Vector2d& q, const PoleField& field);

/// Pose in our frames (heading from the forward axis), position by the mean of both poles.
[[nodiscard]] Pose2 robotPose(const TwoPolePose& pose);
}  // namespace mrpt_ext
