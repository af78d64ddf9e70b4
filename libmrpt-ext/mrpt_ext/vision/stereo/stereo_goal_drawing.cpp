#include "mrpt_ext/vision/drawing.h"
#include "mrpt_ext/vision/stereo/stereo_goal.h"

namespace mrpt_ext
{
namespace
{
const cv::Scalar kStripe(80, 220, 80), kWall(255, 120, 60), kJunction(0, 200, 255), kCorner(255, 0, 255),
    kText(60, 60, 255);

cv::Point rounded(const cv::Point2d& p) { return {cvRound(p.x), cvRound(p.y)}; }

void drawLines(cv::Mat& drawing, const std::vector<FloorLine>& lines, const StereoCamera& camera,
               const cv::Scalar& colour)
{
  for (const FloorLine& line : lines)
  {
    const auto a = camera.pixelOf(line.middle + line.first * line.direction);
    const auto b = camera.pixelOf(line.middle + line.last * line.direction);
    if (a && b) cv::line(drawing, rounded(*a), rounded(*b), colour, 1, cv::LINE_AA);
  }
}
}  // namespace

cv::Mat drawStereoGoal(const cv::Mat& left, const StereoGoalView& view, const StereoGoalSettings& settings)
{
  if (left.empty() || left.depth() != CV_8U) return {};
  cv::Mat drawing = coloured(left);
  if (!view.problem.empty()) write(drawing, view.problem, {10, 24}, kText);
  drawLines(drawing, view.markings.stripes, settings.camera, kStripe);
  drawLines(drawing, view.markings.walls, settings.camera, kWall);
  for (const FloorJunction& junction : view.markings.junctions)
    cv::circle(drawing, rounded(junction.pixel), 4, kJunction, 1, cv::LINE_AA);
  for (const LineLandmark& landmark : view.landmarks)
  {
    cv::circle(drawing, rounded(landmark.left), 6, kJunction, 2, cv::LINE_AA);
    write(drawing, cv::format("%s %d", nameOf(landmark.kind), cvRound(100 * landmark.measured.range)),
          rounded(landmark.left) + cv::Point(8, 4), kText);
  }
  for (const GoalCorner& corner : view.corners)
  {
    const cv::Point2d foot(corner.u_left, corner.white_bottom);
    const cv::Point2d top(corner.u_left + (corner.row_top - corner.white_bottom) * settings.camera.uprightSlope(foot),
                          corner.row_top);
    cv::line(drawing, rounded(foot), rounded(top), kCorner, 2, cv::LINE_AA);
    write(drawing, std::to_string(cvRound(100 * corner.measured.range)), rounded(top) - cv::Point(8, 6), kText);
  }
  return drawing;
}
}  // namespace mrpt_ext
