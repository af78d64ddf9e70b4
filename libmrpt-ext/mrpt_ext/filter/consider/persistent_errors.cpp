#include "mrpt_ext/filter/consider/persistent_errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mrpt_ext
{
namespace
{
constexpr double kForget = 100;  // [s] without a detection, after which an error does not matter any more
}  // namespace

void PersistentErrors::restart()
{
  tracks_.clear();
  effects_.clear();
}

void PersistentErrors::update(const LinearStep& step)
{
  predict(step);
  learn(step);
  correct(step);
  correlation_.forget(step.time);
  std::erase_if(tracks_, [&](const auto& entry) { return entry.second.seen < step.time - kForget; });
}

void PersistentErrors::transform(const KalmanMatrix& A)
{
  const auto congruent = [&](KalmanMatrix& C) { C = (A * C * A.transpose()).eval(); };
  for (auto& [kind, effect] : effects_)
  {
    congruent(effect.white);
    std::for_each(effect.lasting.begin(), effect.lasting.end(), congruent);
  }
  for (auto& [source, track] : tracks_)
    for (KalmanVector& response : track.response) response = (A * response).eval();
}

void PersistentErrors::predict(const LinearStep& step)
{
  transform(step.motion_jacobian);
  for (std::size_t k = 0; k < kErrorDurations.size(); ++k)
  {
    const double remaining = std::exp(-std::max(0.0, step.motion.duration) / kErrorDurations[k]);
    for (auto& [source, track] : tracks_) track.response[k] *= remaining;
  }
}

void PersistentErrors::learn(const LinearStep& step)
{
  for (const InnovationRow& row : step.rows)
  {
    // The estimate has followed a part of the error.
    PerDuration visible;
    visible.fill(1);
    if (const auto track = tracks_.find(row.source); track != tracks_.end())
      for (std::size_t k = 0; k < visible.size(); ++k)
        visible[k] -= row.row.jacobian.dot(track->second.response[k]) / std::sqrt(row.row.variance);
    correlation_.add(step.time, row, visible);
  }
}

void PersistentErrors::correct(const LinearStep& step)
{
  transform(step.remaining);
  const KalmanVector no_response = KalmanVector::Zero(size_);
  const KalmanMatrix no_effect = KalmanMatrix::Zero(size_, size_);
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const InnovationRow& row = step.rows[i];
    const KalmanVector by_error = std::sqrt(row.row.variance) * step.gains[i];
    Effect& effect =
        effects_.try_emplace(row.source.kind(), Effect{no_effect, {no_effect, no_effect, no_effect}}).first->second;
    Track& track = tracks_.try_emplace(row.source, Track{0, {no_response, no_response, no_response}}).first->second;
    track.seen = step.time;
    effect.white += by_error * by_error.transpose();
    for (std::size_t k = 0; k < kErrorDurations.size(); ++k)
    {
      KalmanVector& response = track.response[k];
      effect.lasting[k] +=
          by_error * by_error.transpose() + response * by_error.transpose() + by_error * response.transpose();
      response += by_error;
    }
  }
}

Eigen::VectorXd PersistentErrors::lastingVariances(const LinearStep& step) const
{
  Eigen::VectorXd variances(static_cast<Eigen::Index>(step.rows.size()));
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const PerDuration shares = correlation_.lastingShares(step.rows[i].source.kind());
    variances[static_cast<Eigen::Index>(i)] =
        std::accumulate(shares.begin(), shares.end(), 0.0) * step.rows[i].row.variance;
  }
  return variances;
}

KalmanMatrix PersistentErrors::added() const
{
  KalmanMatrix sum = KalmanMatrix::Zero(size_, size_);
  for (const auto& [kind, effect] : effects_)
  {
    const PerDuration shares = correlation_.lastingShares(kind);
    for (std::size_t k = 0; k < shares.size(); ++k) sum += shares[k] * effect.lasting[k];
    // What lasts is no noise of single measurements; where it alone is more than stated, no noise is left.
    sum -= std::min(1.0, std::accumulate(shares.begin(), shares.end(), 0.0)) * effect.white;
  }
  return sum;
}
}  // namespace mrpt_ext
