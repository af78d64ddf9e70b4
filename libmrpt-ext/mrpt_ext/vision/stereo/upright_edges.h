#pragma once

#include <vector>

#include "mrpt_ext/vision/stereo/goal_colour.h"
#include "mrpt_ext/vision/stereo/stereo_camera.h"

namespace mrpt_ext
{
/// Rows and columns of the left image in which an upright edge is sought.
struct EdgeWindow
{
  int first_row = 0, last_row = 0;
  double column = 0;  ///< where it is expected in the middle row
  int reach = 0;      ///< [px] to either side

  [[nodiscard]] int middle() const { return (first_row + last_row) / 2; }
};

/// Which edges of both images belong together.
struct EdgeSearch
{
  double least_disparity = 0, most_disparity = 0;  ///< [px]
  int min_rows = 5;                                ///< rows in which both images must show the step
  double std_column = 0, std_disparity = 0;        ///< [px] beyond the scatter of the rows
};

/// An upright edge seen in both images.
struct UprightEdge
{
  cv::Point2d middle;                                       ///< [px] in the left image, in the window's middle row
  double disparity = 0, std_column = 0, std_disparity = 0;  ///< [px]
  std::vector<int> rows;                                    ///< in which both images show it
};

/// Upright edges of one kind in a rectified pair of BGR images, each row located by itself (paper 004: the search at
/// full scale), rows moved along the edge, which leans when the cameras have a pitch, outliers removed, and the same
/// step found in the right image. An edge of a colour is located by its brightness as well, which counts more
/// where they do not agree: colour is often coarser than the pixels. It counts less where a goal's side in the shade
/// stands between white and colour, which one image may show and the other hardly. Several edges may be so close that
/// only the disparity tells them apart.
class UprightEdges
{
 public:
  UprightEdges(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera, const EdgeSearch& search);

  /// The edges of a window, that which most rows agree with first.
  [[nodiscard]] std::vector<UprightEdge> in(const EdgeWindow& window, const ColourStep& step) const;
  /// A first look: columns, in the window's middle row, at which enough rows of the left image show the step, those of
  /// most rows first.
  [[nodiscard]] std::vector<double> columnsIn(const EdgeWindow& window, const ColourStep& step) const;

 private:
  struct RowStep;
  struct InBrightness;
  [[nodiscard]] double atMiddleRow(double column, int row, const EdgeWindow& window) const;
  [[nodiscard]] std::vector<RowStep> stepsInLeft(const EdgeWindow& window, const ColourStep& step) const;
  void searchRight(std::vector<RowStep>& rows, const EdgeWindow& window, const ColourStep& step) const;
  [[nodiscard]] InBrightness inBrightness(const std::vector<RowStep>& rows, const EdgeWindow& window, int side) const;
  [[nodiscard]] UprightEdge measured(const std::vector<RowStep>& rows, const EdgeWindow& window,
                                     const ColourStep& step) const;

  const cv::Mat& left_;
  const cv::Mat& right_;
  const StereoCamera& camera_;
  EdgeSearch search_;
  cv::Vec3f least_white_;
};
}  // namespace mrpt_ext
