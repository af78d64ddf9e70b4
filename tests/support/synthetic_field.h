#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/stereo/stereo_camera.h"

// A football field painted by casting rays, for tests of the narrow stereo pair: a white wall with a goal across the
// view, upright coloured boards for robots, and markings on a dark floor. Positions are (forward, left) of the left
// camera [m].
namespace mrpt_ext::testing
{
/// The camera of a small robot, 320 x 240 pixels.
inline StereoCamera smallCamera()
{
  StereoCamera camera;
  camera.size = {320, 240};
  camera.fx = camera.fy = 300;
  camera.cx = 159.5, camera.cy = 119.5;
  camera.baseline = 0.03, camera.height = 0.06, camera.pitch = degToRad(6);
  return camera;
}

inline const cv::Vec3d kYellow(45, 185, 205), kBlue(150, 70, 40), kWhite(200, 200, 200), kFloor(60, 58, 62),
    kBackground(140, 150, 150);

/// Something upright across the view.
struct Board
{
  double forward = 1, right = -0.1, left = 0.1;  ///< [m] `right` and `left` are both counted to the left
  double height = 0.05;                          ///< [m]
  cv::Vec3d colour = kYellow;
};

/// Something upright along the view, as the side of a goal.
struct SideBoard
{
  double left = 0.2;             ///< [m]
  double first = 1, last = 1.2;  ///< [m] forward
  double height = 0.05;          ///< [m]
  cv::Vec3d colour{200, 200, 200};
};

struct Marking
{
  Eigen::Vector2d from, to;  ///< [m]
};

struct FieldPicture
{
  StereoCamera camera = smallCamera();
  double wall = 0.8;             ///< [m] forward
  std::vector<Board> boards;     ///< before the wall, nearer ones first; a goal is one in the wall's plane
  std::vector<SideBoard> sides;  ///< before everything else but boards where they begin
  std::vector<Marking> markings;
  double line_width = 0.003;  ///< [m]
  double noise = 3;           ///< [grey levels]
  bool mirrors = false;       ///< the floor
};

inline cv::Vec3d colourSeen(const FieldPicture& picture, const Eigen::Vector3d& origin, const Eigen::Vector3d& ray)
{
  const double to_floor = ray.z() < 0 ? -origin.z() / ray.z() : 1e9;
  for (const SideBoard& side : picture.sides)
  {
    const Eigen::Vector3d p = origin + (side.left - origin.y()) / ray.y() * ray;
    const bool is_hidden = std::any_of(picture.boards.begin(), picture.boards.end(),
                                       [&](const Board& board)
                                       {
                                         const double y = origin.y() + board.forward / ray.x() * ray.y();
                                         return board.forward <= side.first && y > board.right && y < board.left;
                                       });
    if (!is_hidden && p.x() >= side.first && p.x() <= side.last && p.z() >= 0 && p.z() <= side.height)
      return side.colour;
  }
  for (const Board& board : picture.boards)
  {
    const Eigen::Vector3d p = origin + board.forward / ray.x() * ray;
    if (p.z() >= 0 && p.z() <= board.height && p.y() > board.right && p.y() < board.left) return board.colour;
  }
  const Eigen::Vector3d on_wall = origin + picture.wall / ray.x() * ray;
  if (on_wall.z() > 0.05) return kBackground;
  if (on_wall.z() >= 0) return kWhite;
  if (picture.mirrors)
    return 0.95 * colourSeen(picture, {origin.x(), origin.y(), -origin.z()}, {ray.x(), ray.y(), -ray.z()});
  const Eigen::Vector2d position = (origin + to_floor * ray).head<2>();
  for (const Marking& m : picture.markings)
  {
    const Eigen::Vector2d line = m.to - m.from, d = position - m.from;
    const double along = d.dot(line) / line.squaredNorm();
    if (along >= 0 && along <= 1 && (d - along * line).norm() < 0.5 * picture.line_width) return kWhite;
  }
  return kFloor;
}

inline cv::Mat paintSide(const FieldPicture& picture, double left_by, int seed)
{
  constexpr int kRays = 4;
  const StereoCamera& camera = picture.camera;
  const double c = std::cos(camera.pitch), s = std::sin(camera.pitch);
  cv::Mat image(camera.size, CV_32FC3), noise(camera.size, CV_32FC3);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
    {
      cv::Vec3d sum(0, 0, 0);
      for (int k = 0; k < kRays * kRays; ++k)
      {
        const double du = (k % kRays + 0.5) / kRays - 0.5, dv = (k / kRays + 0.5) / kRays - 0.5;
        const double x = (u + du - camera.cx) / camera.fx, y = (v + dv - camera.cy) / camera.fy;
        sum += colourSeen(picture, {0, left_by, camera.height}, {c - y * s, -x, -s - y * c});
      }
      image.at<cv::Vec3f>(v, u) = cv::Vec3f(sum * (1.0 / (kRays * kRays)));
    }
  cv::GaussianBlur(image, image, {0, 0}, 0.5);
  cv::RNG(static_cast<std::uint64_t>(seed)).fill(noise, cv::RNG::NORMAL, 0, picture.noise);
  image += noise;
  image.convertTo(image, CV_8UC3);
  return image;
}

struct StereoPair
{
  cv::Mat left, right;
};

inline StereoPair paint(const FieldPicture& picture, int seed = 1)
{
  return {paintSide(picture, 0, 2 * seed), paintSide(picture, -picture.camera.baseline, 2 * seed + 1)};
}
}  // namespace mrpt_ext::testing
