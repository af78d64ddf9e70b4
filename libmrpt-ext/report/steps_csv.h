#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Text of steps.csv: `t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict`, every estimate of every method,
/// ordered by time and then as the methods are listed. Unix time [s], metres, covariances [m^2], cpp [rad^2].
/// phi_deg and cpp are empty where no heading is known, ess where there are no particles.
[[nodiscard]] std::string stepsCsv(const RunRecord& record);
}  // namespace mrpt_ext
