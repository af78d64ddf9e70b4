#include "mrpt_ext/vision/tags/tag_facing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/vision/tags/tag_fit.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLeastHorizontal = 0.5;  ///< of a normal whose direction from above means something
constexpr double kEdgeOn = 0.03;          ///< cosine to the line of sight, at which a tag cannot be read
constexpr double kFar = 14;               ///< of chi-squared: less than a thousandth of the probability is beyond
constexpr double kFallen = 1e-3;          ///< of chi-squared, by which it falls again behind a saddle
constexpr double kLargestStep = 0.12;     ///< [rad] between directions; a standard deviation where that is smaller
constexpr int kMostSteps = 40;            ///< to either side
constexpr int kDescentSteps = 6;
constexpr double kDescended = 1e-4;  ///< share of chi-squared

/// Sums over directions on a regular grid, weighted by their likelihoods.
struct Lobe
{
  double weight = 0;            ///< of the integral, relative to the best pose's density
  double mean = 0, second = 0;  ///< moments of the offset from the lobe's pose [rad]

  void add(double offset, double likelihood)
  {
    weight += likelihood;
    mean += likelihood * offset;
    second += likelihood * offset * offset;
  }
};

/// The likelihood of the directions about one pose, as far as its own valley reaches.
class ValleyOfTag
{
 public:
  ValleyOfTag(const TagPose& pose, const TagSight& sight, double best, bool only)
      : pose_{pose.rotation, pose.centre}, residual_(pose.residual), sight_(sight), best_(best), only_(only)
  {
    const TagNormal normal = normalOf(pose_, sight_);
    yaw_ = normal.yaw;
    const double variance = normal.by_rotation * pose.covariance.topLeftCorner<3, 3>() * normal.by_rotation.transpose();
    step_ = std::min(std::sqrt(variance), kLargestStep);
  }

  [[nodiscard]] Facing::Attitude attitude() const
  {
    Lobe lobe;
    lobe.add(0, likelihood(residual_));
    for (const double side : {-1.0, 1.0}) walk(side * step_, lobe);
    const double mean = lobe.mean / lobe.weight;
    // A grid that is no finer than the lobe is wide still has its variance, one with a single point has not.
    const double variance = std::max(lobe.second / lobe.weight - mean * mean, square(step_) / 12);
    return {wrap(yaw_ + mean), std::sqrt(variance), lobe.weight * step_};
  }

 private:
  [[nodiscard]] double likelihood(double residual) const { return std::exp(0.5 * (best_ - residual)); }

  /// Turns the tag step by step, all else fitted.
  void walk(double step, Lobe& lobe) const
  {
    const Eigen::Vector3d up = sight_.level.row(2).transpose();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(step, up).toRotationMatrix();
    RigidPose pose = pose_;
    double before = residual_;
    for (int k = 1; k <= kMostSteps; ++k)
    {
      pose.rotation = turn * pose.rotation;
      if (normalOf(pose, sight_).towards < kEdgeOn) return;
      const auto there = descended(pose, sight_, {kDescentSteps, kDescended, wrap(yaw_ + k * step)});
      if (!there || there->residual > best_ + kFar) return;
      if (!only_ && there->residual < before - kFallen) return;  // down into the other valley
      lobe.add(k * step, likelihood(there->residual));
      pose = {there->rotation, there->centre}, before = there->residual;
    }
  }

  RigidPose pose_;
  double residual_;
  const TagSight& sight_;
  double best_;
  bool only_;
  double yaw_ = 0, step_ = 0;
};
}  // namespace

std::optional<Facing> facingOf(const std::vector<TagPose>& poses, const TagCorners& corners, double edge,
                               const PinholeCamera& camera, const TagNoise& noise)
{
  const TagSight sight(corners, edge, camera, noise);
  std::vector<Facing::Attitude> attitudes;
  for (const TagPose& pose : poses)
  {
    if (pose.residual > poses.front().residual + kFar) continue;
    const TagNormal normal = normalOf({pose.rotation, pose.centre}, sight);
    if (normal.horizontal < kLeastHorizontal || normal.towards < kEdgeOn) return std::nullopt;
    attitudes.push_back(ValleyOfTag(pose, sight, poses.front().residual, poses.size() == 1).attitude());
  }
  if (attitudes.empty()) return std::nullopt;
  if (attitudes.size() == 1) return Facing::single(attitudes[0].yaw, attitudes[0].std);
  return Facing::either(attitudes[0], attitudes[1], attitudes[1].weight / (attitudes[0].weight + attitudes[1].weight));
}
}  // namespace mrpt_ext
