#include "mrpt_ext/diagnosis/self_diagnosis.h"

#include "mrpt_ext/diagnosis/noise_check.h"
#include "mrpt_ext/diagnosis/systematic_error_check.h"

namespace mrpt_ext
{
void SelfDiagnosis::add(const Frame& frame, const FilterLocalizer& filter)
{
  innovations_.add(frame, filter.lastStep());
  joined_.add(frame);
  landmarks_.add(frame);
  if (!frame.readings.empty()) agreement_.add(filter.lastStep().verdict, filter.lastStep().inlier_ratio);
}

std::vector<std::string> SelfDiagnosis::hints(const std::map<std::string, LandmarkRecord>& landmarks) const
{
  std::vector<std::string> hints;
  const auto add = [&](const std::vector<std::string>& more) { hints.insert(hints.end(), more.begin(), more.end()); };
  if (const std::string fault = landmarks_.hint(landmarks); !fault.empty())
    add({fault});  // whatever else the innovations show follows from it
  else if (const std::string never = agreement_.hint(landmarks_, landmarks); !never.empty())
    add({never});
  else if (const std::string late = delayHint(innovations_.delay(), input_.logged_sensors); !late.empty())
    add({late});  // the same holds for a wrong clock
  else
  {
    add(systematicErrorHints(innovations_.errors(), input_.logged_sensors));
    add(noiseHints(innovations_.sensors()));
  }
  add(joined_.hints());
  return hints;
}
}  // namespace mrpt_ext
