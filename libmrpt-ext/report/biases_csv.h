#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Text of biases.csv: `t,bias,mean,std`, the systematic errors as the filter knew them after every frame.
[[nodiscard]] std::string biasesCsv(const std::vector<BiasRow>& biases);
}  // namespace mrpt_ext
