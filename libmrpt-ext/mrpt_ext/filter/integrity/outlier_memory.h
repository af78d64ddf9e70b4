#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/likelihood/landmark_clutter.h"

namespace mrpt_ext
{
/// Outliers that come in bursts: a radio whose line of sight is blocked errs for seconds, a false mirror is seen from
/// everywhere nearby. Taken as independent of each other, a hundred of them outweigh any odometry.
///
/// Per sensor and landmark a Markov chain in continuous time with two states, clear and outlying (the model of Gilbert
/// and Elliott for bursts on a line, Bell Syst. Tech. J. 39 and 42): its stationary share of outliers is the clutter
/// probability of the landmark, its dwell time is learned per sensor from how often an inlier follows an outlier. So a
/// burst costs a pose its first outlier; where outliers are independent the dwell time shrinks to nothing.
class OutlierMemory
{
 public:
  explicit OutlierMemory(std::size_t landmarks) : landmarks_(landmarks) {}

  /// Clutter probabilities for a reading of `sensor` at `time` [s], from the stationary ones.
  [[nodiscard]] LandmarkClutter predict(const std::string& sensor, double time, LandmarkClutter stationary) const;
  /// What one identified detection was: with which probability an outlier, if that had been `stationary` before.
  struct Outcome
  {
    double outlier, stationary;
  };
  void observe(const std::string& sensor, double time, std::size_t landmark, const Outcome& outcome);

 private:
  /// After the last detection of a landmark.
  struct State
  {
    double outlying = 0;  // probability
    double time = -1e9;   // [s]
  };
  struct Sensor
  {
    std::vector<State> states;
    double exits = 1, outlying_time = 1;  // expected number, [s]: as if one burst of a second had been seen
    [[nodiscard]] double predict(std::size_t landmark, double time, double stationary) const;
  };
  std::size_t landmarks_;
  std::map<std::string, Sensor> sensors_;
};
}  // namespace mrpt_ext
