#include "mrpt_ext/filter/hypothesis_injection.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/filter/particles/particle_bias.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMostOdds = 10;
constexpr double kNearXy = 0.7, kNearPhi = degToRad(20.0);  // of a place that is held: the way finds it roughly

bool isNear(const Pose2& a, const Pose2& b)
{
  return (a.position() - b.position()).norm() < kNearXy && std::abs(wrap(a.phi - b.phi)) < kNearPhi;
}
}  // namespace

double weightElsewhere(const HypothesisSet& along_way, const Pose2& held)
{
  double others = 0;
  for (const PoseHypothesis& place : along_way)
    if (!isNear(held, place.pose.mean)) others += place.weight;
  return others;
}

double injectedShare(double others, double log_odds_held)
{
  const double said = others < 1 ? std::min(others / (1 - others), kMostOdds) : kMostOdds;
  const double odds = said * std::exp(-std::max(0.0, log_odds_held));
  return odds / (1 + odds);
}

void injectHypotheses(ParticleSet& particles, const HypothesisSet& along_way, double share, std::size_t count,
                      RandomStream& random)
{
  double known = 0;
  for (const PoseHypothesis& place : along_way) known += place.weight;
  if (!(known > 0)) return;
  for (float& log_w : particles.log_weight) log_w += static_cast<float>(std::log1p(-share));
  const std::size_t kept = particles.size();
  for (const PoseHypothesis& place : along_way)
  {
    const double weight = share * place.weight / known;
    if (weight < kLeastPlaceShare) continue;
    const Matrix3d factor = Eigen::LLT<Matrix3d>(place.pose.covariance).matrixL();
    const Eigen::MatrixXd normals = exactNormals(3, count, random);
    for (Eigen::Index i = 0; i < normals.cols(); ++i)
    {
      const Vector3d off = factor * normals.col(i);
      const Pose2& mean = place.pose.mean;
      particles.add({mean.x + off.x(), mean.y + off.y(), wrap(mean.phi + off.z())},
                    std::log(weight / static_cast<double>(count)));
    }
  }
  drawBiases(particles, kept, random);
}
}  // namespace mrpt_ext
