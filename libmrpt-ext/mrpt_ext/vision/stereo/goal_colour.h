#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

namespace mrpt_ext
{
/// How a goal's colour differs from the white wall beside it under the same light: each channel as a share of the
/// white's. Shares of neighbours do not depend on gain and colour cast, so no white balance is needed.
class GoalColour
{
 public:
  GoalColour() : GoalColour(cv::Vec3f(0.22F, 0.9F, 1.F)) {}
  /// Shares of blue, green and red, as coded in the image.
  explicit GoalColour(const cv::Vec3f& shares);

  /// True if `colour` beside `white` is this colour: it has the hue of the model's shares, which paint keeps when it is
  /// mixed with white or lies in the shade, is not greyer than half saturated, and neither much brighter than the white
  /// nor nearly black.
  [[nodiscard]] bool matches(const cv::Vec3f& white, const cv::Vec3f& colour) const;

  /// The channel in which colour and white differ most.
  [[nodiscard]] int darkChannel() const { return dark_; }

 private:
  int dark_ = 0, bright_ = 2;
  float hue_ = 0;
};

/// What changes at an upright edge of a white wall.
struct ColourStep
{
  const GoalColour* colour = nullptr;  ///< beside the white; null: white in the shade
  int side = 1;                        ///< +1: colour or shade are at larger columns
};

/// The least level of each channel at which something may be the white of this image: a share of the brightest tenth of
/// every `step`-th pixel of every `step`-th row. Yellow and blue are far below it in one channel.
[[nodiscard]] cv::Vec3f leastWhite(const cv::Mat& bgr, int step);

[[nodiscard]] inline bool isWhite(const cv::Vec3f& pixel, const cv::Vec3f& least_white)
{
  return pixel[0] >= least_white[0] && pixel[1] >= least_white[1] && pixel[2] >= least_white[2];
}

/// Where this step is in one row. Columns are to a fraction of a pixel: of paint where half of a pixel is white, of
/// shade where the brightness is half way between both sides.
[[nodiscard]] std::vector<double> stepsInRow(const cv::Mat& bgr, int row, int first_column, int last_column,
                                             const ColourStep& step, const cv::Vec3f& least_white);

/// Light that is missing between white and paint, where a goal's side in the shade may be. Sums of some rows.
struct PaintInShade
{
  double of_paint = 0, of_white = 0;  ///< that pixels lack as far as they are paint, and as far as they are white
  double contrast = 0;                ///< white's brightness less the paint's

  /// [px] that it moves a step of brightness towards the white. Where colour is coarser than the pixels, some of the
  /// white lacks light or has too much of it as well; that is no shade, nor is as much of the paint's.
  [[nodiscard]] double shift() const;
  PaintInShade& operator+=(const PaintInShade& other);
};

struct BrightnessStep
{
  double column = 0;
  PaintInShade shade;
};

/// Where the brightness alone is half way between both sides of a step that is about `column`, white at smaller columns
/// (`side` +1) or at larger ones (-1). Cameras and JPEG files may keep colour in coarser pixels than brightness. But
/// brightness takes paint in the shade for less white.
[[nodiscard]] std::optional<BrightnessStep> brightnessStepAt(const cv::Mat& bgr, int row, double column, int side);

/// The mean of three pixels of a row around a column; of fewer at the image's border.
[[nodiscard]] cv::Vec3f meanAround(const cv::Mat& bgr, int row, int column);
}  // namespace mrpt_ext
