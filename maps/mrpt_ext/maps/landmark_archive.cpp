#include "mrpt_ext/maps/landmark_archive.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <vector>

#include "mrpt_ext/observations/observation_archive.h"

namespace mrpt_ext
{
bool hasDirections(const LandmarkTable& landmarks)
{
  return std::any_of(landmarks.all().begin(), landmarks.all().end(),
                     [](const Landmark& landmark) { return landmark.yaw.has_value(); });
}

void writeLandmarks(mrpt::serialization::CArchive& out, const LandmarkTable& landmarks, bool with_directions)
{
  out << static_cast<std::uint32_t>(landmarks.size());
  for (const Landmark& landmark : landmarks.all())
  {
    out << static_cast<std::int32_t>(landmark.id);
    for (double coordinate : landmark.position) out << coordinate;
    out << landmark.category << landmark.stddev.x() << landmark.stddev.y();
    if (!with_directions) continue;
    writeOptional(out, landmark.yaw);
    out << landmark.std_yaw;
  }
}

LandmarkTable readLandmarks(mrpt::serialization::CArchive& in, bool with_directions)
{
  const auto count = in.ReadAs<std::uint32_t>();
  std::vector<Landmark> landmarks;  // grows as it is read: a damaged count cannot claim memory at once
  for (std::uint32_t i = 0; i < count; ++i)
  {
    Landmark landmark;
    landmark.id = in.ReadAs<std::int32_t>();
    for (double& coordinate : landmark.position) in >> coordinate;
    in >> landmark.category >> landmark.stddev.x() >> landmark.stddev.y();
    if (with_directions)
    {
      landmark.yaw = readOptional(in);
      in >> landmark.std_yaw;
    }
    landmarks.push_back(std::move(landmark));
  }
  return LandmarkTable(std::move(landmarks));
}

void writeOptions(mrpt::serialization::CArchive& out, const LandmarkLikelihoodOptions& options)
{
  out << options.clutter_probability << options.detection_probability << options.default_std_bearing
      << options.default_std_range;
}

void readOptions(mrpt::serialization::CArchive& in, LandmarkLikelihoodOptions& options)
{
  in >> options.clutter_probability >> options.detection_probability >> options.default_std_bearing >>
      options.default_std_range;
}
}  // namespace mrpt_ext
