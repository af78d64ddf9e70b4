#include "mrpt_ext/vision/mirror_votes.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mrpt_ext
{
namespace
{
constexpr int kReducedSide = 120;         ///< [px] the shorter side of the image in which votes are cast
constexpr std::size_t kMostEdges = 4000;  ///< strongest gradients that vote
constexpr double kAspectStep = 0.15;      ///< between the aspect ratios that are tried
constexpr float kRadialStride = 1.5F;     ///< [px] between the votes of one pixel
constexpr std::size_t kCentres = 2;       ///< per aspect ratio
constexpr int kRadiiPerCentre = 2;
constexpr double kPointsAtCentre = 0.95;  ///< cosine between a rim's gradient and the direction to the centre

/// A pixel with a strong gradient; in stretched coordinates the rim is a circle.
struct EdgePixel
{
  float u, v, gu, gv;
};

struct Candidate
{
  AxisEllipse ellipse;  ///< reduced pixels
  float votes = 0;
};

std::vector<EdgePixel> strongEdges(const cv::Mat& reduced)
{
  cv::Mat du, dv;
  cv::Sobel(reduced, du, CV_32F, 1, 0, 3, 1.0 / 8);
  cv::Sobel(reduced, dv, CV_32F, 0, 1, 3, 1.0 / 8);
  struct Strength
  {
    float square;
    int row, col;
  };
  std::vector<Strength> strengths;
  for (int row = 0; row < reduced.rows; ++row)
    for (int col = 0; col < reduced.cols; ++col)
    {
      const float u = du.at<float>(row, col), v = dv.at<float>(row, col);
      if (u * u + v * v > 1) strengths.push_back({u * u + v * v, row, col});
    }
  if (strengths.size() > kMostEdges)
  {
    std::nth_element(strengths.begin(), strengths.begin() + kMostEdges, strengths.end(),
                     [](const Strength& a, const Strength& b) { return a.square > b.square; });
    strengths.resize(kMostEdges);
  }
  std::vector<EdgePixel> edges;
  for (const Strength& s : strengths)
    edges.push_back(
        {static_cast<float>(s.col), static_cast<float>(s.row), du.at<float>(s.row, s.col), dv.at<float>(s.row, s.col)});
  return edges;
}

/// The same edges in an image whose v axis is stretched by `aspect`.
std::vector<EdgePixel> stretched(std::vector<EdgePixel> edges, float aspect)
{
  for (EdgePixel& e : edges)
  {
    e.v *= aspect;
    e.gv /= aspect;
    const float norm = std::sqrt(e.gu * e.gu + e.gv * e.gv);
    e.gu /= norm;
    e.gv /= norm;
  }
  return edges;
}

/// Votes along the gradients (`sign` 1: the mirror is brighter than what surrounds it) or against them.
cv::Mat castVotes(const std::vector<EdgePixel>& edges, const cv::Size& size, float low, float high, float sign)
{
  cv::Mat votes = cv::Mat::zeros(size, CV_32F);
  float* const cells = votes.ptr<float>();
  const float end_u = static_cast<float>(size.width), end_v = static_cast<float>(size.height);
  const int most = static_cast<int>((high - low) / kRadialStride) + 1;
  for (const EdgePixel& e : edges)
  {
    float u = e.u + sign * low * e.gu + 0.5F, v = e.v + sign * low * e.gv + 0.5F;
    const float step_u = sign * kRadialStride * e.gu, step_v = sign * kRadialStride * e.gv;
    for (int k = 0; k < most && u >= 0 && v >= 0 && u < end_u && v < end_v; ++k, u += step_u, v += step_v)
      cells[static_cast<int>(v) * size.width + static_cast<int>(u)] += 1;
  }
  cv::GaussianBlur(votes, votes, {9, 9}, 2);
  return votes;
}

/// Radii at which most gradients point to or away from the centre, each with its share of a full circle.
void addRadii(const std::vector<EdgePixel>& edges, const cv::Point& centre, float aspect, float low, float high,
              float sign, std::vector<Candidate>& candidates)
{
  std::vector<float> histogram(static_cast<std::size_t>(high) + 4, 0.F);
  for (const EdgePixel& e : edges)
  {
    const float du = e.u - static_cast<float>(centre.x), dv = e.v - static_cast<float>(centre.y);
    const float r = std::sqrt(du * du + dv * dv);
    if (r < low || r > high || -sign * (du * e.gu + dv * e.gv) < kPointsAtCentre * r) continue;
    histogram[static_cast<std::size_t>(r + 0.5F)] += 1 / r;
  }
  for (int k = 0; k < kRadiiPerCentre; ++k)
  {
    std::size_t best = 1;
    float most = 0;
    for (std::size_t i = 1; i + 1 < histogram.size(); ++i)
      if (const float sum = histogram[i - 1] + histogram[i] + histogram[i + 1]; sum > most) most = sum, best = i;
    if (!(most > 0)) return;
    const double radius = static_cast<double>(best);
    candidates.push_back({{{static_cast<double>(centre.x), centre.y / static_cast<double>(aspect)},
                           radius,
                           radius / static_cast<double>(aspect)},
                          most});
    for (std::size_t i = best < 3 ? 0 : best - 3; i <= std::min(best + 3, histogram.size() - 1); ++i) histogram[i] = 0;
  }
}
}  // namespace

std::vector<AxisEllipse> voteForMirrors(const cv::Mat& grey, const OutlineSettings& settings)
{
  const int side = std::min(grey.rows, grey.cols);
  const double factor = std::max(1.0, static_cast<double>(side) / kReducedSide);
  cv::Mat reduced;
  cv::resize(grey, reduced, {}, 1 / factor, 1 / factor, cv::INTER_AREA);
  const auto edges = strongEdges(reduced);
  const float low = static_cast<float>(settings.min_radius * side / factor);
  const float high = static_cast<float>(settings.max_radius * side / factor);

  std::vector<Candidate> candidates;
  const int steps = std::max(1, static_cast<int>(std::ceil((settings.max_aspect - settings.min_aspect) / kAspectStep)));
  for (int i = 0; i < steps; ++i)
  {
    const double middle = (i + 0.5) / steps;
    const float aspect = static_cast<float>(settings.min_aspect + middle * (settings.max_aspect - settings.min_aspect));
    const auto pixels = stretched(edges, aspect);
    const cv::Size size(reduced.cols, static_cast<int>(std::ceil(static_cast<float>(reduced.rows) * aspect)));
    for (const float sign : {1.F, -1.F})
    {
      cv::Mat votes = castVotes(pixels, size, low, high, sign);
      for (std::size_t k = 0; k < kCentres; ++k)
      {
        cv::Point best;
        cv::minMaxLoc(votes, nullptr, nullptr, nullptr, &best);
        addRadii(pixels, best, aspect, low, high, sign, candidates);
        cv::circle(votes, best, 6, cv::Scalar(0), cv::FILLED);
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.votes > b.votes; });
  std::vector<AxisEllipse> mirrors;
  for (const Candidate& c : candidates)
    mirrors.push_back({{(c.ellipse.centre.x + 0.5) * factor - 0.5, (c.ellipse.centre.y + 0.5) * factor - 0.5},
                       c.ellipse.semi_u * factor,
                       c.ellipse.semi_v * factor});
  return mirrors;
}
}  // namespace mrpt_ext
