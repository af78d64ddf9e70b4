#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Text of hypotheses.csv: `t,rank,x,y,phi_deg,weight,source` in the order given; rank 0 is the best.
[[nodiscard]] std::string hypothesesCsv(const std::vector<HypothesisRow>& hypotheses);
}  // namespace mrpt_ext
