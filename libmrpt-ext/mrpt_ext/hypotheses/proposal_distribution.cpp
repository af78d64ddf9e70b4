#include "mrpt_ext/hypotheses/proposal_distribution.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace mrpt_ext
{
namespace
{
constexpr double kSupport2 = 64;     // squared Mahalanobis distance beyond which a component's density counts as zero
constexpr double kMinShare = 0.02;   // of each component at least: the solvers' scores may be wrong
constexpr std::size_t kProbes = 64;  // components at which the overlap is counted
constexpr std::size_t kBlockOfPoses = 128;
constexpr double kMaxLog2Peak = 100;   // of a component without extent, in single precision
constexpr double kVagueHeading = 2.0;  // [rad] from this standard deviation on the heading counts as unknown
}  // namespace

ProposalDistribution::ProposalDistribution(const HypothesisSet& hypotheses, const PoseRegion& region,
                                           double uniform_share, double inflation, const Vector3d& min_std)
    : region_(region), uniform_share_(hypotheses.empty() ? 1.0 : uniform_share)
{
  double sum = 0;
  for (const PoseHypothesis& hypothesis : hypotheses)
  {
    Component component;
    component.mean = hypothesis.pose.mean;
    Matrix3d covariance = inflation * hypothesis.pose.covariance;
    covariance.diagonal() += min_std.cwiseAbs2();
    component.heading_known = hypothesis.heading_known && !(covariance(2, 2) > square(kVagueHeading));
    if (!component.heading_known)
    {
      covariance.row(2).setZero();
      covariance.col(2).setZero();
      covariance(2, 2) = 1;
    }
    const Eigen::LLT<Matrix3d> llt(covariance);
    if (!covariance.allFinite() || !isFinite(component.mean) || llt.info() != Eigen::Success) continue;
    component.cholesky = llt.matrixL();
    component.information = llt.solve(Matrix3d::Identity());
    const double log_det = 2 * component.cholesky.diagonal().array().log().sum();
    component.log_norm = component.heading_known ? -0.5 * (log_det + 3 * std::log(kTwoPi))
                                                 : -0.5 * (log_det + 2 * std::log(kTwoPi)) - std::log(kTwoPi);
    component.half_phi = std::sqrt(kSupport2 * covariance(2, 2));
    component.share = std::max(hypothesis.weight, kMinShare);
    sum += component.share;
    component.cumulative = sum;
    components_.push_back(component);
    const Vector2d half = (kSupport2 * covariance.diagonal().head<2>()).cwiseSqrt();
    support_.push_back({component.mean.x, component.mean.y, half.x(), half.y()});
  }
  for (Component& component : components_)
  {
    component.share /= sum;
    component.cumulative /= sum;
  }
  if (components_.empty()) uniform_share_ = 1;
}

Pose2 ProposalDistribution::sample(RandomStream& random) const
{
  if (random.uniform() < uniform_share_) return region_.sample(random);
  const double u = random.uniform();
  const auto chosen = std::partition_point(components_.begin(), components_.end() - 1,
                                           [u](const Component& component) { return component.cumulative <= u; });
  const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
  const Vector3d offset = chosen->cholesky * Vector3d(a, b, c);
  const double phi = chosen->heading_known ? chosen->mean.phi + offset.z() : random.uniform(-kPi, kPi);
  return {chosen->mean.x + offset.x(), chosen->mean.y + offset.y(), wrap(phi)};
}

double ProposalDistribution::density(const Pose2& pose) const
{
  double sum = 0;
  for (std::size_t k = 0; k < components_.size(); ++k)
  {
    if (!support_[k].contains(pose.x, pose.y)) continue;
    const Component& component = components_[k];
    Vector3d d(pose.x - component.mean.x, pose.y - component.mean.y, 0.0);
    const auto add = [&](double turned)
    {
      d.z() = turned;
      const double distance2 = d.dot(component.information * d);
      if (distance2 < kSupport2) sum += component.share * std::exp(component.log_norm - 0.5 * distance2);
    };
    if (!component.heading_known)
    {
      add(0);
      continue;
    }
    // Wrapped normal distribution: samples a full turn away have the same heading.
    const double turned = wrap(pose.phi - component.mean.phi);
    for (const double full_turn : {-kTwoPi, 0.0, kTwoPi})
      if (std::abs(turned + full_turn) < component.half_phi) add(turned + full_turn);
  }
  return uniform_share_ * region_.density(pose) + (1 - uniform_share_) * sum;
}

MixtureTerm ProposalDistribution::termOf(std::size_t component, const Vector2d& origin) const
{
  const Component& c = components_[component];
  MixtureTerm term{.x = static_cast<float>(c.mean.x - origin.x()),
                   .y = static_cast<float>(c.mean.y - origin.y()),
                   .phi = static_cast<float>(c.mean.phi),
                   .half_x = static_cast<float>(support_[component].half_x),
                   .half_y = static_cast<float>(support_[component].half_y),
                   .full_turns = c.heading_known && c.half_phi > kPi};
  const auto form = [&](Eigen::Index i, Eigen::Index j)
  { return static_cast<float>(-0.5 * std::numbers::log2e * (i == j ? 1 : 2) * c.information(i, j)); };
  term.xx = form(0, 0);
  term.xy = form(0, 1);
  term.yy = form(1, 1);
  if (c.heading_known)
  {
    term.xphi = form(0, 2);
    term.yphi = form(1, 2);
    term.phiphi = form(2, 2);
  }
  const double log_peak = c.log_norm + std::log(c.share * (1 - uniform_share_));
  term.log2_peak = static_cast<float>(std::clamp(log_peak * std::numbers::log2e, -kMaxLog2Peak, kMaxLog2Peak));
  return term;
}

std::vector<float> ProposalDistribution::densities(const PoseBatch& poses) const
{
  std::vector<MixtureTerm> terms;
  for (std::size_t k = 0; k < components_.size(); ++k) terms.push_back(termOf(k, poses.origin));
  std::vector<float> density(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
    density[i] = static_cast<float>(uniform_share_ * region_.density(poses[i]));
  for (std::size_t first = 0; first < poses.size(); first += kBlockOfPoses)
  {
    const std::size_t count = std::min(kBlockOfPoses, poses.size() - first);
    const auto x = poses.x.subspan(first, count), y = poses.y.subspan(first, count);
    const auto [low_x, high_x] = std::minmax_element(x.begin(), x.end());
    const auto [low_y, high_y] = std::minmax_element(y.begin(), y.end());
    for (const MixtureTerm& term : terms)
      if (term.reaches(*low_x, *high_x, *low_y, *high_y))
        addDensity(term, x, y, poses.phi.subspan(first, count), std::span(density).subspan(first, count));
  }
  return density;
}

double ProposalDistribution::overlap() const
{
  const std::size_t stride = 1 + components_.size() / kProbes;
  std::size_t reached = 0, probes = 0;
  for (std::size_t k = 0; k < components_.size(); k += stride, ++probes)
    for (const SupportBox& box : support_) reached += box.contains(support_[k].x, support_[k].y) ? 1 : 0;
  return static_cast<double>(reached) / static_cast<double>(std::max<std::size_t>(1, probes));
}
}  // namespace mrpt_ext
