#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/files/atomic_file.h"

namespace mrpt_ext
{
/// Writes hypotheses.csv: `t,rank,x,y,phi_deg,weight,source` in the order given; rank 0 is the best.
void hypothesesCsv(const DiskBackedSequence<HypothesisRow>& hypotheses, const TextSink& write);
}  // namespace mrpt_ext
