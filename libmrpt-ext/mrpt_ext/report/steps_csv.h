#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/files/atomic_file.h"

namespace mrpt_ext
{
/// Writes steps.csv: `t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict`, every estimate of every method,
/// ordered by time and then as the methods are listed. Unix time [s], metres, covariances [m^2], cpp [rad^2].
/// phi_deg and cpp are empty where no heading is known, ess where there are no particles.
void stepsCsv(const RunRecord& record, const TextSink& write);
}  // namespace mrpt_ext
