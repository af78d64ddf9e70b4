#pragma once

#include <memory>
#include <optional>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// A scenario while it is played: the log comes record by record, so that hours of it need no memory. Same scenario,
/// same records. Map, path, odometry, every object and every sensor draw from random streams of their own, so that
/// changing one leaves the others as they were.
class SimulatedDrive
{
 public:
  /// Throws InputError (configuration) for a scenario that cannot be played; the scenario must outlive the drive.
  explicit SimulatedDrive(const Scenario& scenario);
  ~SimulatedDrive();
  SimulatedDrive(SimulatedDrive&&) noexcept;

  /// The next record in the order of time; nothing at the end.
  [[nodiscard]] std::optional<Record> next();
  [[nodiscard]] const LandmarkTable& map() const;
  /// Sampled at truth_rate_hz, and at the end.
  [[nodiscard]] Trajectory truth() const;

 private:
  class Simulation;
  std::unique_ptr<Simulation> simulation_;
};

/// The whole drive in memory: log, map and truth.
[[nodiscard]] Recording simulate(const Scenario& scenario);
}  // namespace mrpt_ext
