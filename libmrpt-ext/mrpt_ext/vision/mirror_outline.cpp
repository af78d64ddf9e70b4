#include "mrpt_ext/vision/mirror_outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/vision/mirror_votes.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kTriedCandidates = 12;  ///< of the coarse search
constexpr double kDominantShare = 0.7;        ///< of the rim: no other candidate can have as much
constexpr double kRivalShare = 0.7;   ///< of the best one's share of a rim, that another one needs to be a rival
constexpr double kSameCentre = 0.02;  ///< of the rim's radius; circles about one centre do no harm
constexpr int kCoarseRays = 128, kFineRays = 512;
constexpr double kCoarseWindow = 0.12;  ///< half width of the search across the rim, share of its radius
constexpr double kFineWindow = 0.02;
constexpr int kStepsPerRay = 2;           ///< strongest steps of brightness that are kept
constexpr int kSamples = 240;             ///< ellipses proposed by four steps each
constexpr std::uint64_t kSampleSeed = 1;  ///< fixed: an image always gives the same outline
constexpr double kCoarseTolerance = 2.0;  ///< [px]
constexpr double kFineTolerance = 1.0;    ///< [px]
constexpr int kHalfStep = 2;              ///< [px] brightness is compared this far before and behind

constexpr int kNoiseGrid = 13;  ///< [px] spacing of the pixels at which the noise is estimated
constexpr double kStepSignificance = 3.5;

/// A step of brightness across the suspected rim.
struct RimStep
{
  int ray = 0;
  cv::Point2d point;
  double height = 0;  ///< [grey levels]
};

double sample(const cv::Mat& grey, const cv::Point2d& p)
{
  const int u = static_cast<int>(p.x), v = static_cast<int>(p.y);
  const double a = p.x - u, b = p.y - v;
  const uchar* const upper = grey.ptr<uchar>(v) + u;
  const uchar* const lower = grey.ptr<uchar>(v + 1) + u;
  return (1 - b) * ((1 - a) * upper[0] + a * upper[1]) + b * ((1 - a) * lower[0] + a * lower[1]);
}

bool isInside(const cv::Mat& grey, const cv::Point2d& p)
{
  return p.x >= 0 && p.y >= 0 && p.x < grey.cols - 1 && p.y < grey.rows - 1;
}

/// The strongest steps along one ray, to a fraction of a pixel.
void addSteps(const cv::Mat& grey, const AxisEllipse& rim, int ray, int rays, double window, double min_height,
              std::vector<RimStep>& steps)
{
  const double angle = kTwoPi * ray / rays;
  const cv::Point2d direction(std::cos(angle), std::sin(angle));
  const double pixel = 1 / std::hypot(rim.semi_u * direction.x, rim.semi_v * direction.y);
  const int reach = static_cast<int>(std::ceil(window / pixel)) + kHalfStep;
  std::vector<double> profile;
  double first = 0;
  for (int i = -reach; i <= reach; ++i)
  {
    const cv::Point2d p = rim.at(direction, 1 + i * pixel);
    if (!isInside(grey, p))
    {
      if (profile.empty()) continue;
      break;
    }
    if (profile.empty()) first = 1 + i * pixel;
    profile.push_back(sample(grey, p));
  }
  std::vector<double> heights(profile.size(), 0.0);
  for (std::size_t i = kHalfStep; i + kHalfStep < profile.size(); ++i)
    heights[i] = std::abs(profile[i + 2] + profile[i + 1] - profile[i - 1] - profile[i - 2]) / 2;

  std::vector<RimStep> found;
  for (std::size_t i = 1; i + 1 < heights.size(); ++i)
  {
    const double before = heights[i - 1], here = heights[i], behind = heights[i + 1];
    if (here < min_height || here < before || !(here > behind)) continue;
    const double offset = 0.5 * (before - behind) / (before - 2 * here + behind);
    found.push_back({ray, rim.at(direction, first + (static_cast<double>(i) + offset) * pixel), here});
  }
  std::stable_sort(found.begin(), found.end(), [](const RimStep& a, const RimStep& b) { return a.height > b.height; });
  if (found.size() > kStepsPerRay) found.resize(kStepsPerRay);
  steps.insert(steps.end(), found.begin(), found.end());
}

std::vector<RimStep> stepsAcross(const cv::Mat& grey, const AxisEllipse& rim, int rays, double window,
                                 double min_height)
{
  std::vector<RimStep> steps;
  for (int ray = 0; ray < rays; ++ray) addSteps(grey, rim, ray, rays, window, min_height, steps);
  return steps;
}

/// Distance to an ellipse without roots: good enough beside the rim of a nearly round mirror.
class AlgebraicDistance
{
 public:
  explicit AlgebraicDistance(const AxisEllipse& e)
      : centre_(e.centre),
        per_u_(1 / square(e.semi_u)),
        per_v_(1 / square(e.semi_v)),
        scale_(0.25 * (e.semi_u + e.semi_v))
  {
  }
  double operator()(const cv::Point2d& p) const
  {
    return scale_ * (square(p.x - centre_.x) * per_u_ + square(p.y - centre_.y) * per_v_ - 1);
  }

 private:
  cv::Point2d centre_;
  double per_u_, per_v_, scale_;
};

/// The nearest step of every ray, if it is near enough.
std::vector<cv::Point2d> supportOf(const AxisEllipse& ellipse, const std::vector<RimStep>& steps, double tolerance)
{
  std::vector<cv::Point2d> support;
  const AlgebraicDistance distance_of(ellipse);
  int ray = -1;
  double nearest = tolerance;
  for (const RimStep& step : steps)
  {
    const double distance = std::abs(distance_of(step.point));
    if (step.ray != ray) nearest = tolerance;
    if (!(distance < nearest)) continue;
    if (step.ray == ray && !support.empty() && nearest < tolerance)
      support.back() = step.point;
    else
      support.push_back(step.point);
    ray = step.ray;
    nearest = distance;
  }
  return support;
}

bool isAllowed(const AxisEllipse& e, const cv::Mat& grey, const OutlineSettings& settings)
{
  const double radius = std::sqrt(e.semi_u * e.semi_v) / std::min(grey.rows, grey.cols);
  return radius >= settings.min_radius && radius <= settings.max_radius && e.aspect() >= settings.min_aspect &&
         e.aspect() <= settings.max_aspect;
}

/// The ellipse with most support among those through four steps.
std::optional<AxisEllipse> bestSample(const cv::Mat& grey, const std::vector<RimStep>& steps,
                                      const OutlineSettings& settings)
{
  if (steps.size() < 8) return std::nullopt;
  RandomStream random(kSampleSeed);
  std::optional<AxisEllipse> best;
  std::size_t most = 0;
  std::vector<cv::Point2d> four(4);
  for (int trial = 0; trial < kSamples; ++trial)
  {
    for (cv::Point2d& p : four) p = steps[random.below(steps.size())].point;
    const auto ellipse = ellipseThrough(four);
    if (!ellipse || !isAllowed(*ellipse, grey, settings)) continue;
    const std::size_t support = supportOf(*ellipse, steps, kCoarseTolerance).size();
    if (support > most) most = support, best = ellipse;
  }
  return best;
}

/// The smallest step of brightness that is not just noise: of the steps on a sparse grid, hardly one is higher.
double leastStep(const cv::Mat& grey, const OutlineSettings& settings)
{
  std::vector<int> steps;
  for (int v = kNoiseGrid; v < grey.rows; v += kNoiseGrid)
  {
    const uchar* const row = grey.ptr<uchar>(v);
    for (int u = kNoiseGrid; u + kHalfStep < grey.cols; u += kNoiseGrid)
      steps.push_back(std::abs(row[u + 2] + row[u + 1] - row[u - 1] - row[u - 2]));
  }
  if (steps.empty()) return settings.min_contrast;
  return std::max(settings.min_contrast,
                  kStepSignificance * upperMedian(std::move(steps)) / (2 * kNormalMedianDeviation));
}

/// Rays of which a step is within the tolerance of the rim, less as many as have one there by chance: what is as near
/// but beyond the tolerance tells.
double shareOfRim(const AxisEllipse& rim, std::size_t support, std::size_t steps)
{
  const double window = 2 * kFineWindow * std::sqrt(rim.semi_u * rim.semi_v), band = 2 * kFineTolerance;
  const double beyond = static_cast<double>(steps - support) * band / std::max(band, window - band);
  return (static_cast<double>(support) - beyond) / kFineRays;
}

std::optional<MirrorOutline> refine(const cv::Mat& grey, const AxisEllipse& coarse, double least_step,
                                    const OutlineSettings& settings)
{
  AxisEllipse rim = coarse;
  EllipseFit fit;
  std::vector<cv::Point2d> support;
  std::size_t steps_seen = 0;
  for (const double tolerance : {kCoarseTolerance, kFineTolerance, kFineTolerance})
  {
    const auto steps = stepsAcross(grey, rim, kFineRays, kFineWindow, least_step);
    support = supportOf(rim, steps, tolerance);
    steps_seen = steps.size();
    const auto refined = refineEllipse(rim, support);
    if (!refined || !isAllowed(refined->ellipse, grey, settings)) return std::nullopt;
    fit = *refined;
    rim = fit.ellipse;
  }
  MirrorOutline outline;
  outline.rim = rim;
  outline.std_centre = std::sqrt((fit.covariance(0, 0) + fit.covariance(1, 1)) / 2);
  const Eigen::Vector2d by_axes(1 / rim.semi_v, -rim.aspect() / rim.semi_v);
  outline.std_aspect = std::sqrt(by_axes.dot(fit.covariance.bottomRightCorner<2, 2>() * by_axes));
  outline.visible_share = shareOfRim(rim, support.size(), steps_seen);
  outline.support = std::move(support);
  return outline;
}
}  // namespace

std::optional<MirrorOutline> findMirrorOutline(const cv::Mat& grey, const OutlineSettings& settings)
{
  const double least_step = leastStep(grey, settings);
  std::vector<MirrorOutline> outlines;
  std::vector<AxisEllipse> candidates = voteForMirrors(grey, settings);
  if (candidates.size() > kTriedCandidates) candidates.resize(kTriedCandidates);
  for (const AxisEllipse& candidate : candidates)
  {
    const auto steps = stepsAcross(grey, candidate, kCoarseRays, kCoarseWindow, least_step);
    const auto coarse = bestSample(grey, steps, settings);
    if (!coarse) continue;
    if (auto outline = refine(grey, *coarse, least_step, settings)) outlines.push_back(std::move(*outline));
    if (!outlines.empty() && outlines.back().visible_share > kDominantShare) break;
  }
  const auto best = std::max_element(outlines.begin(), outlines.end(),
                                     [](const MirrorOutline& a, const MirrorOutline& b)
                                     { return a.visible_share < b.visible_share; });
  if (best == outlines.end() || best->visible_share < settings.min_visible_share) return std::nullopt;
  for (const MirrorOutline& other : outlines)
    if (cv::norm(other.rim.centre - best->rim.centre) > kSameCentre * best->rim.semi_v &&
        other.visible_share > kRivalShare * best->visible_share)
      best->rival = other.rim;
  return *best;
}
}  // namespace mrpt_ext
