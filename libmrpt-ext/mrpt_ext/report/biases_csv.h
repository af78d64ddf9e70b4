#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/files/atomic_file.h"

namespace mrpt_ext
{
/// Writes biases.csv: `t,bias,mean,std`, the estimated biases after every frame.
void biasesCsv(const DiskBackedSequence<BiasRow>& biases, const TextSink& write);
}  // namespace mrpt_ext
