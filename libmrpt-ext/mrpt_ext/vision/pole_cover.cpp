#include "mrpt_ext/vision/pole_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mrpt_ext/vision/slice_profile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kBelowFirst = 1.5, kBelowLast = 5.5;  ///< [px] below the foot: beyond its blur, and as far as that
constexpr std::array<std::array<double, 2>, 2> kBesidePole{
    {{0.1, 0.4}, {0.65, 0.95}}};        ///< shares of the pole's height
constexpr double kLookedAtRowStep = 1;  ///< [px]
constexpr double kMostWidths = 2.5;     ///< of the pole, half of it, to either side of where it is seen
constexpr double kLeastChange = 0.2;    ///< between the floor and what is in front, share of their levels
constexpr double kSameColour = 0.5;     ///< of that change, by which what is in front may vary
constexpr int kCoverColumns = 2;        ///< neighbouring columns [px]

/// Mean grey levels of a column of the image of the mirror.
std::optional<cv::Vec3d> meanLevels(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth, double low,
                                    double high)
{
  const int rows = std::max(1, static_cast<int>(std::lround((high - low) * mirror.focalLength() / kLookedAtRowStep)));
  cv::Vec3d sum(0, 0, 0);
  for (int row = 0; row < rows; ++row)
  {
    const auto levels = levelsAt(image, mirror.pixel(azimuth, low + (row + 0.5) / rows * (high - low)));
    if (!levels) return std::nullopt;
    sum += *levels / rows;
  }
  return sum;
}

/// The columns about a pole, below its foot and beside it.
class ColumnsAboutPole
{
 public:
  ColumnsAboutPole(const cv::Mat& image, const HyperbolicMirror& mirror, const FieldObjectSizes& sizes,
                   const ObjectGuess& guess)
      : image_(image), mirror_(mirror), middle_(guess.azimuth)
  {
    const auto rho_of = [&](double share)
    { return mirror.rhoAt(mirror.slopeOf(share * sizes.pole_height, guess.distance)); };
    const double foot = rho_of(0), pixel = 1 / mirror.focalLength();
    below_low_ = foot - kBelowLast * pixel, below_high_ = foot - kBelowFirst * pixel;
    for (std::size_t i = 0; i < kBesidePole.size(); ++i)
      beside_[i] = {rho_of(kBesidePole[i][0]), rho_of(kBesidePole[i][1])};
    step_ = pixel / foot;
    floor_ = below(0);
  }

  /// True when the same is seen below the foot as beside the pole, and it is not what is in front of the pole.
  [[nodiscard]] bool isCovered(int column) const
  {
    const auto seen = below(column);
    if (!floor_ || !seen) return false;
    const double change = cv::norm(*seen - *floor_);
    if (change < kLeastChange * std::max(cv::norm(*seen), cv::norm(*floor_))) return false;
    return std::all_of(beside_.begin(), beside_.end(),
                       [&](const std::array<double, 2>& rho)
                       {
                         const auto beside = meanLevels(image_, mirror_, middle_ + column * step_, rho[0], rho[1]);
                         return beside && cv::norm(*seen - *beside) < kSameColour * change;
                       });
  }
  /// How much of what is in `cover` is in this column below the foot, the rest being floor.
  [[nodiscard]] double shareOf(int cover, int column) const
  {
    const auto all = below(cover), some = below(column);
    if (!all || !some) return 0;
    const cv::Vec3d change = *all - *floor_;
    return (*some - *floor_).dot(change) / change.dot(change);
  }
  /// [rad]
  [[nodiscard]] double step() const { return step_; }

 private:
  [[nodiscard]] std::optional<cv::Vec3d> below(int column) const
  {
    return meanLevels(image_, mirror_, middle_ + column * step_, below_low_, below_high_);
  }

  const cv::Mat& image_;
  const HyperbolicMirror& mirror_;
  double middle_ = 0, step_ = 0;  ///< [rad]
  double below_low_ = 0, below_high_ = 0;
  std::array<std::array<double, 2>, kBesidePole.size()> beside_{};  ///< image radii
  std::optional<cv::Vec3d> floor_;                                  ///< grey levels in front of the pole
};

/// Where what hides the pole on one side begins, in columns from the middle: where half of a column below the foot is
/// it.
std::optional<double> edgeOfCover(const ColumnsAboutPole& columns, int side, int last)
{
  int found = 0, covered = 0;
  for (int i = 1; i <= last && covered < kCoverColumns; ++i)
    covered = columns.isCovered(side * (found = i)) ? covered + 1 : 0;
  if (covered < kCoverColumns) return std::nullopt;
  double outer = 1;
  for (int i = found - 1; i > 0; --i)
  {
    const double share = columns.shareOf(side * found, side * i);
    if (share < 0.5) return i + (0.5 - share) / (outer - share);
    outer = share;
  }
  return std::nullopt;
}
}  // namespace

std::optional<PoleCover> coverOfPole(const cv::Mat& image, const HyperbolicMirror& mirror,
                                     const FieldObjectSizes& sizes, const ObjectGuess& guess)
{
  const ColumnsAboutPole columns(image, mirror, sizes, guess);
  const int last = static_cast<int>(kMostWidths * guess.half_width / columns.step());
  const auto low = edgeOfCover(columns, -1, last), high = edgeOfCover(columns, 1, last);
  if (low.has_value() == high.has_value()) return std::nullopt;
  const int side = low ? -1 : 1;
  return PoleCover{guess.azimuth + side * (low ? *low : *high) * columns.step(), side};
}
}  // namespace mrpt_ext
