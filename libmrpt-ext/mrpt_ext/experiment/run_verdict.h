#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/particle_filter.h"

namespace mrpt_ext
{
/// Verdict on a whole run from the filter's own verdicts: that of the last seconds (the worse of the last step and the
/// most frequent one), with the lost steps before. Never from ground truth.
[[nodiscard]] VerdictWithReason verdictOfFilter(const RunRecord& run, const FilterStep& last);

/// For runs with closed forms only: ok when most frames were answered, ambiguous when most had candidates that could
/// not be ranked, lost otherwise.
[[nodiscard]] VerdictWithReason verdictOfClosedForms(const RunRecord& run);
}  // namespace mrpt_ext
