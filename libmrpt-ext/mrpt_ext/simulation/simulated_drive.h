#pragma once

#include <memory>
#include <optional>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// A simulated scenario, record by record, so that hours of it need no memory. The same scenario gives the same
/// records. Map, path, odometry, every object and every sensor use random streams of their own, so that changing one
/// does not affect the others.
class SimulatedDrive
{
 public:
  /// Throws InputError (configuration) for an impossible scenario; the scenario must outlive the drive.
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
}  // namespace mrpt_ext
