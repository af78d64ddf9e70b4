#include "mrpt_ext/filter/integrity/outlier_memory.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kMostOutlying = 0.95;  // probability: an inlier is recognised at once
constexpr double kMostDwells = 3;       // between two detections that tell of them
}  // namespace

double OutlierMemory::Sensor::predict(std::size_t landmark, double time, double stationary) const
{
  const State& state = states[landmark];
  // The rates of leaving and of entering balance at the stationary share.
  const double leaving = exits / outlying_time, both = leaving / std::max(1e-3, 1 - stationary);
  const double remembered = std::exp(-both * std::max(0.0, time - state.time));
  // An inlier does not make the next outlier less likely: some come alone.
  const double outlying = stationary + remembered * std::max(0.0, state.outlying - stationary);
  return std::min(outlying, std::max(kMostOutlying, stationary));
}

LandmarkClutter OutlierMemory::predict(const std::string& sensor, double time, LandmarkClutter stationary) const
{
  const auto found = sensors_.find(sensor);
  if (found == sensors_.end()) return stationary;
  for (std::size_t j = 0; j < stationary.size(); ++j) stationary[j] = found->second.predict(j, time, stationary[j]);
  return stationary;
}

void OutlierMemory::observe(const std::string& sensor, double time, std::size_t landmark, const Outcome& outcome)
{
  Sensor& of_sensor = sensors_[sensor];
  of_sensor.states.resize(landmarks_);
  // By Bayes: the outcome rests on the stationary share, and what is remembered is the better prior.
  const double before = of_sensor.predict(landmark, time, outcome.stationary);
  const double outlier = outcome.outlier * before / outcome.stationary;
  const double inlier = (1 - outcome.outlier) * (1 - before) / (1 - outcome.stationary);
  const double outlying = outlier + inlier > 0 ? outlier / (outlier + inlier) : before;
  State& state = of_sensor.states[landmark];
  const double elapsed = time - state.time;
  // What was most likely clear says nothing of dwell times, nor does a pair that is further apart than some of them.
  if (state.outlying > 0.5 && elapsed > 0 && elapsed * of_sensor.exits < kMostDwells * of_sensor.outlying_time)
  {
    of_sensor.exits += 1 - outlying;
    of_sensor.outlying_time += elapsed;
  }
  state = {outlying, time};
}
}  // namespace mrpt_ext
