#include "sample_observations.h"

#include "mrpt_ext/observations/timestamps.h"

namespace mrpt_ext
{
namespace
{
void fillHeader(mrpt::obs::CObservation& observation, const char* label)
{
  observation.timestamp = timestampOf(1178275990.9749144);
  observation.sensorLabel = label;
  observation.setSensorPose(mrpt::poses::CPose3D(0.1, -0.2, 0.5, 0.7, 0, 0));
}
}  // namespace

CObservationLandmarkBearings::Ptr sampleBearings()
{
  auto observation = CObservationLandmarkBearings::Create();
  fillHeader(*observation, "camera left");
  observation->field_of_view = 1.5;
  observation->max_range = 8;
  observation->detections = {{.id = 4, .category = "pole", .bearing = 0.25, .std_bearing = 0.01},
                             {.id = -1, .category = "", .bearing = -3.0, .std_bearing = 0.02}};
  return observation;
}

CObservationStereoRanges::Ptr sampleRanges()
{
  auto observation = CObservationStereoRanges::Create();
  fillHeader(*observation, "stereo");
  observation->field_of_view = 1.2;
  observation->max_range = 5;
  observation->baseline_focal = 60;
  observation->horizontal = true;
  observation->detections = {{.id = 2,
                              .category = "corner",
                              .range = 3.0,
                              .std_range = 0.05,
                              .std_disparity = 0.25,
                              .bearing = 0.5,
                              .std_bearing = 0.01},
                             {.id = 3,
                              .category = "post",
                              .range = 2.0,
                              .std_range = 0,
                              .std_disparity = 0.5,
                              .bearing = {},
                              .std_bearing = 0},
                             {.id = -1,
                              .category = "far",
                              .range = {},
                              .std_range = 0,
                              .std_disparity = 0,
                              .bearing = -0.1,
                              .std_bearing = 0.02}};
  return observation;
}

CObservationStereoRanges::Ptr sampleFacings()
{
  auto observation = sampleRanges();
  observation->detections[0].facing = Facing::single(2.5, 0.02);
  observation->detections[1].facing = Facing::either({-3, 0.1}, {3, 0.2}, 0.25);
  return observation;
}

CObservationRunningFix::Ptr sampleFix()
{
  auto observation = CObservationRunningFix::Create();
  fillHeader(*observation, "goal");
  observation->horizontal = true;
  observation->id = 9;
  observation->first_timestamp = timestampOf(1178275988.5);
  observation->first_range = 1.25;
  observation->first_std = 0.03;
  observation->second_range = 2.5;
  observation->second_std = 0.04;
  observation->displacement = {0.5, -0.25, 0.125};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) observation->displacement_covariance(i, j) = 0.001 * (1 + i + j);
  observation->second_bearing = 0.75;
  observation->second_bearing_std = 0.015;
  return observation;
}

std::vector<mrpt::obs::CObservation::Ptr> samplesOfAllClasses()
{
  return {sampleBearings(), sampleRanges(), sampleFacings(), sampleFix()};
}
}  // namespace mrpt_ext
