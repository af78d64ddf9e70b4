#pragma once

#include "mrpt_ext/simulation/simulated_drive.h"

namespace mrpt_ext::testing
{
/// A whole simulated drive in memory: log, map and truth.
[[nodiscard]] inline Recording simulate(const Scenario& scenario)
{
  SimulatedDrive drive(scenario);
  Recording recording;
  while (auto record = drive.next()) recording.records.push_back(std::move(*record));
  recording.map = drive.map();
  recording.truth = drive.truth();
  return recording;
}
}  // namespace mrpt_ext::testing
