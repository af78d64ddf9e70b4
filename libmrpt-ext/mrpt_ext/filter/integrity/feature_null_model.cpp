#include "mrpt_ext/filter/integrity/feature_null_model.h"

#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
FeatureMixture::Outcome FeatureNullModel::observe(const Reading& part)
{
  const Detection& d = part.detections.front();
  if (d.id != kNoId || !d.bearing) return {-std::log(measurementVolume(d, part.model, max_range_))};
  return d.range ? points_.observe(part, d) : bearings_.observe(part, d);
}

void FeatureNullModel::track(const Reading& correlated)
{
  for (const Detection& d : correlated.detections)
  {
    if (d.id != kNoId || !d.bearing) continue;
    if (d.range)
      points_.track(correlated, d);
    else
      bearings_.track(correlated, d);
  }
}
}  // namespace mrpt_ext
