#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/online/online_localizer.h"

namespace mrpt_ext
{
// The lines of `landmark-localization --live`, one JSON object each. Schema: apps/landmark-localization/README.md.

/// Hands what a line of the input says to the localizer. Throws InputError (data) that tells what is wrong with it.
void applyLiveLine(const std::string& line, OnlineLocalizer& robot);

/// A record of a log as a line of the input, without the line's end: angles in radians, so that no bit of them is lost.
/// Nothing for what --live does not read: running fixes, headings, laser scans.
[[nodiscard]] std::optional<std::string> liveLineOf(const Record& record);

/// An estimate as a line, without the line's end. `biases`: the model that its systematic errors belong to.
[[nodiscard]] std::string liveLineOf(const OnlineEstimate& estimate, const BiasModel& biases, double latency_ms);
/// A mistake in line `number` of the input.
[[nodiscard]] std::string liveErrorLine(std::size_t number, const std::string& message);
}  // namespace mrpt_ext
