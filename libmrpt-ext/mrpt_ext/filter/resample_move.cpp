#include "mrpt_ext/filter/resample_move.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
// Steps relative to the standard deviations of the mode. One is about the best for a Gaussian in five dimensions
// (2.4 / sqrt(5): Roberts, Gelman, Gilks, Ann. Appl. Probab. 7(1), 1997), the smaller ones are for rings,
// the larger one lets a mode of few ancestors grow.
constexpr std::array<double, 4> kStepShares{3.0, 1.0, 0.3, 0.1};
constexpr double kAnyHeadingStdPhi = degToRad(40.0);  // wider: any heading, uncorrelated with the rest
constexpr double kMinMoveVariance = 1e-8;             // so that a mode of copies is moved at all
constexpr double kRotationShare = 0.3;                // of the steps
constexpr std::size_t kMaxWalkingModes = 40;          // the heaviest ones; the others only rotate
constexpr int kMinSweeps = 2;
constexpr std::size_t kMostScored = 400'000'000;  // detections, over all particles and sweeps
constexpr std::size_t kCostOfStep = 120;  // of a particle, in operations (work_counter.h); and of its part in a shape
constexpr double kMinGrowth = 0.1;        // of the logarithm of a mode's volume

/// Distribution of the steps of the particles of one mode.
struct StepShape
{
  KalmanMatrix factor;    // lower, of the covariance of the mode
  double log_volume = 0;  // logarithm of its determinant
};

/// Sums over the particles of one mode, as offsets from the first of them.
struct ModeSums
{
  KalmanVector first, sum;
  KalmanMatrix squares;
  double weight = 0;

  void add(const KalmanVector& point, double w)
  {
    if (first.size() == 0)
    {
      first = point;
      sum = KalmanVector::Zero(point.size());
      squares = KalmanMatrix::Zero(point.size(), point.size());
    }
    KalmanVector offset = point - first;
    offset[2] = wrap(offset[2]);
    weight += w;
    sum += w * offset;
    squares += w * offset * offset.transpose();
  }
};

StepShape shapeOf(const ModeSums& mode)
{
  const KalmanVector mean = mode.sum / mode.weight;
  KalmanMatrix C = mode.squares / mode.weight - mean * mean.transpose();
  if (C(2, 2) > square(kAnyHeadingStdPhi))
  {
    C.row(2).setZero();
    C.col(2).setZero();
    C(2, 2) = square(kAnyHeadingStdPhi);
  }
  C.diagonal().array() += kMinMoveVariance;
  StepShape shape{C.llt().matrixL(), 0};
  shape.log_volume = shape.factor.diagonal().array().log().sum();
  return shape;
}

/// Of the heaviest modes, empty for those without particles.
std::vector<std::optional<StepShape>> stepShapes(const ParticleSet& particles, const std::vector<float>& log_weight,
                                                 const ModeSet& modes)
{
  std::vector<ModeSums> sums(std::min(modes.modes.size(), kMaxWalkingModes));
  WorkCounter::add(kCostOfStep * particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (const auto m = static_cast<std::size_t>(modes.mode_of[i]); m < sums.size())
      sums[m].add(pointOf(particles, i), std::exp(double{log_weight[i]}));
  std::vector<std::optional<StepShape>> shapes;
  for (const ModeSums& mode : sums) shapes.push_back(mode.weight > 0 ? std::optional(shapeOf(mode)) : std::nullopt);
  return shapes;
}

bool hasGrown(const std::vector<std::optional<StepShape>>& before, const std::vector<std::optional<StepShape>>& after)
{
  for (std::size_t m = 0; m < after.size(); ++m)
    if (after[m] && before[m] && after[m]->log_volume > before[m]->log_volume + kMinGrowth) return true;
  return false;
}

/// Only errors that the readings depend on, and that are estimated, are moved.
bool isMoved(const BiasState& state) { return !belongsToOdometry(state.kind) && state.std > 0; }

void keepOthers(const BiasModel& states, KalmanVector& step)
{
  for (std::size_t k = 0; k < states.size(); ++k)
    if (!isMoved(states[k])) step[static_cast<Eigen::Index>(3 + k)] = 0;
}

/// The pose with another heading and the same position of the pivot.
Pose2 turned(const Pose2& pose, const Vector2d& pivot, double heading)
{
  const Vector2d at = pose.position() + rotation(pose.phi) * pivot - rotation(heading) * pivot;
  return {at.x(), at.y(), heading};
}

/// One step for every particle.
ParticleSet proposed(const ParticleSet& particles, const ModeSet& modes,
                     const std::vector<std::optional<StepShape>>& shapes, const Vector2d& pivot, RandomStream& random)
{
  ParticleSet next = particles;
  WorkCounter::add(kCostOfStep * particles.size());
  for (std::size_t i = 0; i < next.size(); ++i)
  {
    if (random.chance(kRotationShare))
    {
      next.setPose(i, turned(particles.pose(i), pivot, random.uniform(-kPi, kPi)));
      continue;
    }
    const auto mode = static_cast<std::size_t>(modes.mode_of[i]);
    if (mode >= shapes.size() || !shapes[mode]) continue;
    KalmanVector normal(shapes[mode]->factor.rows());
    for (double& value : normal) value = random.gaussian();
    KalmanVector step = kStepShares[random.below(kStepShares.size())] * (shapes[mode]->factor * normal);
    keepOthers(next.bias_states, step);
    setPoint(next, i, moved(pointOf(particles, i), step));
  }
  return next;
}

/// Metropolis: accepts a step with the ratio of the posterior densities.
void accept(ParticleSet& particles, const ParticleSet& next, RandomStream& random)
{
  for (std::size_t i = 0; i < next.size(); ++i)
  {
    const double gain = double{next.log_weight[i]} - double{particles.log_weight[i]};
    if (!(std::log(1 - random.uniform()) < gain)) continue;
    particles.setPose(i, next.pose(i));
    particles.log_weight[i] = next.log_weight[i];
    for (std::size_t k = 0; k < particles.bias.size(); ++k) particles.bias[k][i] = next.bias[k][i];
  }
}
}  // namespace

void moveByPosterior(ParticleSet& particles, const ModeSet& modes, const Vector2d& pivot, const LogPosterior& posterior,
                     RandomStream& random, int most_sweeps)
{
  const std::vector<float> log_weight = particles.log_weight;
  auto shapes = stepShapes(particles, log_weight, modes);
  posterior(particles);
  bool growing = true;
  for (int sweep = 0; sweep < kMinSweeps || (growing && sweep < most_sweeps); ++sweep)
  {
    ParticleSet next = proposed(particles, modes, shapes, pivot, random);
    posterior(next);
    accept(particles, next, random);
    auto moved_shapes = stepShapes(particles, log_weight, modes);
    growing = hasGrown(shapes, moved_shapes);
    shapes = std::move(moved_shapes);
  }
  particles.log_weight = log_weight;
}

void rejuvenate(ParticleSet& particles, const ParticleFilterOptions& options, std::span<const Reading> since_start,
                const WeightParticles& weight, RandomStream& random)
{
  Frame all;
  all.readings.assign(since_start.begin(), since_start.end());
  Vector2d pivot = Vector2d::Zero();
  std::size_t scored = 1;  // in one sweep
  for (const Reading& reading : since_start) scored += particles.size() * reading.detections.size();
  for (const Reading& reading : since_start)
    pivot += reading.T_robot_sensor.position() / static_cast<double>(since_start.size());
  const auto posterior = [&](ParticleSet& moved)
  {
    std::fill(moved.log_weight.begin(), moved.log_weight.end(), 0.0F);
    weight(all, moved);
    addBiasLogPrior(moved);
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (!options.region.contains(moved.pose(i))) moved.log_weight[i] = -std::numeric_limits<float>::infinity();
  };
  moveByPosterior(particles, findModes(particles, options.modes, options.threads), pivot, posterior, random,
                  static_cast<int>(std::min<std::size_t>(kMostScored / scored, kMostSweeps)));
}

void addBiasLogPrior(ParticleSet& particles)
{
  for (std::size_t k = 0; k < particles.bias.size(); ++k)
  {
    const BiasState& state = particles.bias_states[k];
    if (!isMoved(state)) continue;
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.log_weight[i] -=
          static_cast<float>(0.5 * square((double{particles.bias[k][i]} - state.mean) / state.std));
  }
}
}  // namespace mrpt_ext
