#pragma once

#include <algorithm>

#include "mrpt_ext/diagnosis/calibration_choice.h"
#include "recorded_drive.h"

namespace mrpt_ext::testing
{
/// A recorded drive with one sensor, "uwb", and landmarks 10, 11, ...
inline CalibrationData recorded(const DrivePlan& plan, int seed)
{
  RandomStream random(static_cast<std::uint64_t>(seed), 3);
  CalibrationData data{.problem = recordedDrive(plan, random), .sensors = {"uwb"}, .identified = {true}};
  for (std::size_t i = 0; i < plan.landmarks.size(); ++i) data.ids.push_back(static_cast<int>(10 + i));
  return data;
}

inline bool has(const std::vector<CalibrationUnknown>& unknowns, CalibrationParameter kind)
{
  return std::any_of(unknowns.begin(), unknowns.end(),
                     [&](const CalibrationUnknown& unknown) { return unknown.parameter == kind; });
}

/// True when an error of this kind is chosen.
inline bool has(const CalibrationChoice& choice, CalibrationParameter kind) { return has(choice.errors, kind); }
}  // namespace mrpt_ext::testing
