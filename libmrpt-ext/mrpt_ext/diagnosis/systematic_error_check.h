#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/diagnosis/delay_hypotheses.h"
#include "mrpt_ext/diagnosis/innovation_regression.h"

namespace mrpt_ext
{
/// A line for a delay of the detections that moves the pose by more than its standard deviation; else empty. `sensors`:
/// labels of the log.
[[nodiscard]] std::string delayHint(const std::optional<DelayFinding>& finding,
                                    const std::vector<std::string>& sensors);

/// A line for each offset and scale that the innovations show, and that moves the pose by more than its standard
/// deviation: what it is, and the command that helps. `sensors`: labels, by number.
[[nodiscard]] std::vector<std::string> systematicErrorHints(const std::vector<RegressedError>& errors,
                                                            const std::vector<std::string>& sensors);
}  // namespace mrpt_ext
