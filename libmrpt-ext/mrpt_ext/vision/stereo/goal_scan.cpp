#include <algorithm>
#include <cstdlib>

#include "mrpt_ext/vision/stereo/goal_corners.h"

namespace mrpt_ext
{
namespace
{
constexpr int kSpan = 8;              ///< [px] between the two pixels compared: both are beside a blurred step
constexpr int kRowGap = 12;           ///< [px] rows without a hit within one candidate
constexpr float kLeastChange = 0.2F;  ///< of blue minus red, share of what may be white; with less there is no colour

struct Hit
{
  int colour, side, column, row;
};

/// Hits of neighbouring rows make a candidate.
void add(std::vector<CornerCandidate>& candidates, const Hit& hit)
{
  for (CornerCandidate& c : candidates)
  {
    if (c.colour != hit.colour || c.side != hit.side || hit.row - c.last_row > kRowGap) continue;
    if (std::abs(hit.column - c.column) > kSpan) continue;
    c.column += 0.25 * (hit.column - c.column);
    c.last_row = hit.row;
    return;
  }
  candidates.push_back({hit.colour, hit.side, static_cast<double>(hit.column), hit.row, hit.row});
}
}  // namespace

std::vector<CornerCandidate> scanForGoals(const cv::Mat& bgr, const GoalCornerSettings& settings)
{
  std::vector<CornerCandidate> candidates;
  const int step = settings.scan_step;
  const cv::Vec3f least_white = leastWhite(bgr, 4 * step);
  const int least_change = cvRound(kLeastChange * least_white[1]);
  for (int row = step / 2; row < bgr.rows; row += step)
  {
    const cv::Vec3b* const pixels = bgr.ptr<cv::Vec3b>(row);
    for (int column = step / 2; column + kSpan < bgr.cols; column += step)
    {
      const cv::Vec3b &a = pixels[column], &b = pixels[column + kSpan];
      if (std::abs((a[0] - a[2]) - (b[0] - b[2])) < least_change) continue;
      for (int colour = 0; colour < static_cast<int>(settings.colours.size()); ++colour)
      {
        const GoalColour& model = settings.colours[static_cast<std::size_t>(colour)];
        if (isWhite(a, least_white) && model.matches(a, b)) add(candidates, {colour, 1, column + kSpan / 2, row});
        if (isWhite(b, least_white) && model.matches(b, a)) add(candidates, {colour, -1, column + kSpan / 2, row});
      }
    }
  }
  // One row alone is noise, or too low to be measured.
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [](const CornerCandidate& c) { return c.last_row == c.first_row; }),
                   candidates.end());
  return candidates;
}
}  // namespace mrpt_ext
