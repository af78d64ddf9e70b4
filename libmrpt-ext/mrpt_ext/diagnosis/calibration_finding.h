#pragma once

#include <string>

#include "mrpt_ext/settings/ini_edit.h"

namespace mrpt_ext
{
/// A value of the configuration beside its estimate from the log.
struct CalibrationFinding
{
  std::string what;  ///< "camera: bearings too large by"
  std::string unit;  ///< of the three numbers, as in the .ini
  double configured = 0;
  double estimate = 0;  ///< from the log
  double std = 0;       ///< of the estimate
  int decimals = 3;
  bool is_flag = false;            ///< values are 0: no, or 1: yes
  std::string why_not_observable;  ///< empty: observable
  IniAssignment line;              ///< that sets the estimate
  bool differs = false;            ///< significantly: the line should be set
  std::string remark;              ///< in place of the line: what no line can set
};
}  // namespace mrpt_ext
