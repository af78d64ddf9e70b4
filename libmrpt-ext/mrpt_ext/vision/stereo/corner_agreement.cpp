#include "mrpt_ext/vision/stereo/corner_agreement.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kAgreementGate = 4;        ///< standard deviations
constexpr double kStdFoot = 0.7;            ///< [px] of a foot, which is found to a row
constexpr double kStdRight = 0.25;          ///< [px] of the rows by which both images differ
constexpr double kStdWidth = 0.02;          ///< of a goal's width, share: its corners are as wide as their paint
constexpr int kFewestCorners = 8;           ///< that tell a constant
constexpr int kFewestGoals = 4;             ///< likewise, with both corners
constexpr int kPatchRows = 4;               ///< [px] by which rows of both images may differ
constexpr int kPatchColumns = 6;            ///< [px] of the patch that is compared
constexpr double kLeastPatchContrast = 20;  ///< [grey levels] squared: mean square of differences between rows
constexpr double kStdOfMedian = 1.2533;
constexpr double kMostSlant = 1.2;  ///< worst fit over the best one from which on a patch tells its row

/// Row of the floor where it is `depth` [m] away along the optical axis.
double floorRow(const StereoCamera& camera, double depth)
{
  const double y = (camera.height / depth - std::sin(camera.pitch)) / std::cos(camera.pitch);
  return camera.cy + camera.fy * y;
}

float brightness(const cv::Mat& image, int row, int column)
{
  const auto& p = image.at<cv::Vec3b>(row, column);
  return static_cast<float>(p[0] + p[1] + p[2]) / 3;
}

/// Mean squared difference of the patches when the right one is `lower` rows; nothing where it leaves the image.
std::optional<double> difference(const cv::Mat& left, const cv::Mat& right, const cv::Rect& patch, int shift, int lower)
{
  const cv::Rect other = patch + cv::Point(shift, lower);
  const cv::Rect whole({0, 0}, left.size());
  if ((other & whole) != other) return std::nullopt;
  double sum = 0;
  for (int row = 0; row < patch.height; ++row)
    for (int column = 0; column < patch.width; ++column)
    {
      const double d =
          brightness(left, patch.y + row, patch.x + column) - brightness(right, other.y + row, other.x + column);
      sum += d * d;
    }
  return sum / patch.area();
}

/// Rows that the right image shows the patch lower: where it differs least, between rows by a parabola.
std::optional<double> rowsLower(const cv::Mat& left, const cv::Mat& right, const cv::Rect& patch, int shift)
{
  std::array<double, 2 * kPatchRows + 1> differences{};
  for (int lower = -kPatchRows; lower <= kPatchRows; ++lower)
  {
    const auto d = difference(left, right, patch, shift, lower);
    if (!d) return std::nullopt;
    differences[static_cast<std::size_t>(lower + kPatchRows)] = *d;
  }
  const auto best = std::min_element(differences.begin(), differences.end());
  if (best == differences.begin() || best + 1 == differences.end()) return std::nullopt;
  const double before = best[-1], after = best[1], bend = before + after - 2 * *best;
  const double worst = *std::max_element(differences.begin(), differences.end());
  if (!(bend > 0) || worst < kLeastPatchContrast || worst < kMostSlant * *best) return std::nullopt;
  return static_cast<double>(best - differences.begin()) - kPatchRows + 0.5 * (before - after) / bend;
}

std::optional<CornerConstant> constantFrom(const std::vector<double>& values, int fewest)
{
  if (static_cast<int>(values.size()) < fewest) return std::nullopt;
  CornerConstant constant;
  constant.value = *median(values);
  constant.count = static_cast<int>(values.size());
  std::vector<double> deviations;
  for (const double v : values) deviations.push_back(std::abs(v - constant.value));
  constant.scatter = *median(deviations) / kNormalMedianDeviation;
  return constant;
}

/// Two corners of one goal, as indices into a frame.
struct GoalPair
{
  std::size_t first = 0, second = 0;
  double width = 0, std = 0;  ///< [m]
};

std::vector<GoalPair> goalsIn(const std::vector<CornerEvidence>& frame)
{
  std::vector<GoalPair> pairs;
  for (std::size_t i = 0; i < frame.size(); ++i)
    for (std::size_t j = i + 1; j < frame.size(); ++j)
    {
      if (frame[i].colour != frame[j].colour) continue;
      const StereoMeasurement &a = frame[i].measured, &b = frame[j].measured;
      const Eigen::Vector2d apart = a.position - b.position;
      const double width = apart.norm();
      if (!(width > 0)) continue;
      const auto along = [&](const StereoMeasurement& m)
      {
        const double in_line = m.position.normalized().dot(apart) / width;
        return std::hypot(in_line * m.std_range,
                          std::sqrt(std::max(0.0, 1 - in_line * in_line)) * m.range * m.std_bearing);
      };
      pairs.push_back({i, j, width, std::hypot(along(a), along(b))});
    }
  return pairs;
}

/// What is left of the feet when pitch or height are corrected.
std::vector<double> feetLeft(const std::vector<CornerEvidence>& corners, const CornerConstants& constants)
{
  std::vector<double> left;
  for (const CornerEvidence& c : corners)
    left.push_back(*c.foot - (constants.pitch ? constants.pitch->value * c.foot_by_pitch : 0) -
                   (constants.height ? constants.height->value * c.foot_by_height : 0));
  return left;
}

void addFeet(CornerConstants& constants, const std::vector<CornerEvidence>& corners)
{
  std::vector<double> pitches, heights;
  for (const CornerEvidence& c : corners)
    pitches.push_back(*c.foot / c.foot_by_pitch), heights.push_back(*c.foot / c.foot_by_height);
  CornerConstants by_pitch, by_height;
  by_pitch.pitch = constantFrom(pitches, kFewestCorners), by_height.height = constantFrom(heights, kFewestCorners);
  if (!by_pitch.pitch || !by_height.height) return;
  constants.stated = constantFrom(feetLeft(corners, {}), 1);
  const auto left_by_pitch = constantFrom(feetLeft(corners, by_pitch), 1);
  const auto left_by_height = constantFrom(feetLeft(corners, by_height), 1);
  const bool is_pitch = left_by_pitch->scatter <= left_by_height->scatter;
  (is_pitch ? constants.pitch : constants.height) = is_pitch ? by_pitch.pitch : by_height.height;
  constants.foot = is_pitch ? left_by_pitch : left_by_height;
}
}  // namespace

double CornerConstant::std() const { return kStdOfMedian * scatter / std::sqrt(std::max(1, count)); }

CornerEvidence evidenceOf(const GoalCorner& corner, const cv::Mat& left, const cv::Mat& right,
                          const StereoCamera& camera)
{
  CornerEvidence evidence;
  evidence.colour = corner.colour, evidence.measured = corner.measured;
  const double depth = corner.measured.depth, slope = camera.fy / std::cos(camera.pitch);
  evidence.foot_by_height = slope / depth;
  evidence.foot_by_pitch = -camera.fy * (1 + square((floorRow(camera, depth) - camera.cy) / camera.fy));
  evidence.std_foot = slope * camera.height / depth * corner.measured.std_range / corner.measured.range;
  if (corner.white_bottom < left.rows - 1) evidence.foot = corner.white_bottom - floorRow(camera, depth);
  const int u = static_cast<int>(std::lround(corner.u_left));
  const int top = static_cast<int>(corner.row_top) - kPatchRows,
            foot = static_cast<int>(corner.white_bottom) + kPatchRows;
  const cv::Rect patch(u - kPatchColumns, top, 2 * kPatchColumns + 1, foot - top);
  if (patch.height > 0 && (patch & cv::Rect({0, 0}, left.size())) == patch)
    evidence.right = rowsLower(left, right, patch, static_cast<int>(std::lround(corner.u_right)) - u);
  return evidence;
}

CornerConstants constantsOf(const std::vector<std::vector<CornerEvidence>>& frames)
{
  std::vector<CornerEvidence> with_foot;
  std::vector<double> rights, widths;
  for (const auto& frame : frames)
  {
    for (const CornerEvidence& c : frame)
    {
      if (c.foot) with_foot.push_back(c);
      if (c.right) rights.push_back(*c.right);
    }
    for (const GoalPair& goal : goalsIn(frame)) widths.push_back(goal.width);
  }
  CornerConstants constants;
  addFeet(constants, with_foot);
  constants.right = constantFrom(rights, kFewestCorners);
  constants.goal_width = constantFrom(widths, kFewestGoals);
  return constants;
}

std::vector<bool> agreeingCorners(const std::vector<CornerEvidence>& frame, const CornerConstants& constants)
{
  const auto isFar = [](double off, double std, const CornerConstant& constant)
  { return std::abs(off) > kAgreementGate * std::hypot(std, constant.scatter); };
  std::vector<bool> agrees;
  for (const CornerEvidence& c : frame)
  {
    const bool foot_is_off = c.foot && constants.foot &&
                             isFar(feetLeft({c}, constants).front() - constants.foot->value,
                                   std::hypot(c.std_foot, kStdFoot), *constants.foot);
    const bool row_is_off =
        c.right && constants.right && isFar(*c.right - constants.right->value, kStdRight, *constants.right);
    agrees.push_back(!foot_is_off && !row_is_off);
  }
  if (!constants.goal_width) return agrees;
  const std::vector<bool> by_themselves = agrees;
  for (const GoalPair& goal : goalsIn(frame))
  {
    if (!by_themselves[goal.first] || !by_themselves[goal.second]) continue;
    const double width = constants.goal_width->value;
    if (isFar(goal.width - width, std::hypot(goal.std, kStdWidth * width), *constants.goal_width))
      agrees[goal.first] = agrees[goal.second] = false;
  }
  return agrees;
}
}  // namespace mrpt_ext
