#include "mrpt_ext/maps/CLandmarkMap2D.h"

#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/maps/known_keys.h"
#include "mrpt_ext/maps/landmark_archive.h"
#include "mrpt_ext/maps/landmark_file.h"
#include "mrpt_ext/maps/landmark_scene.h"
#include "mrpt_ext/observations/observation_conversions.h"

IMPLEMENTS_SERIALIZABLE(CLandmarkMap2D, mrpt::maps::CMetricMap, mrpt_ext)

MAP_DEFINITION_REGISTER("mrpt_ext::CLandmarkMap2D,landmarkMap2D", mrpt_ext::CLandmarkMap2D)

namespace mrpt_ext
{
CLandmarkMap2D::TMapDefinition::TMapDefinition() = default;

void CLandmarkMap2D::TMapDefinition::loadFromConfigFile_map_specific(const mrpt::config::CConfigFileBase& source,
                                                                     const std::string& prefix)
{
  rejectUnknownKeys(
      source, prefix + "_creationOpts",
      {"landmarks_file", "enableSaveAs3DObject", "enableObservationLikelihood", "enableObservationInsertion"});
  landmarks_file = source.read_string(prefix + "_creationOpts", "landmarks_file", landmarks_file);
  likelihood_options.loadFromConfigFile(source, prefix + "_likelihoodOpts");
}

void CLandmarkMap2D::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
  out << "landmarks_file = " << landmarks_file << '\n';
  likelihood_options.dumpToTextStream(out);
}

auto CLandmarkMap2D::internal_CreateFromMapDefinition(const mrpt::maps::TMetricMapInitializer& definition)
    -> decltype(internal_CreateFromMapDefinition(definition))
{
  const auto& own = dynamic_cast<const TMapDefinition&>(definition);
  auto map = std::make_unique<CLandmarkMap2D>(readLandmarkMapFile(findLandmarkFile(own.landmarks_file)));
  map->likelihood_options = own.likelihood_options;
  return handOver<decltype(internal_CreateFromMapDefinition(definition))>(std::move(map));
}

// Version 1 adds the directions in which landmarks face. A map without them is written as version 0, as before.
std::uint8_t CLandmarkMap2D::serializeGetVersion() const { return hasDirections(landmarks_) ? 1 : 0; }

void CLandmarkMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  writeLandmarks(out, landmarks_, hasDirections(landmarks_));
  writeOptions(out, likelihood_options);
  out << genericMapParams;
}

void CLandmarkMap2D::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
  switch (version)
  {
    case 0:
    case 1:
      landmarks_ = readLandmarks(in, version > 0);
      readOptions(in, likelihood_options);
      in >> genericMapParams;
      break;
    default:
      MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  }
}

std::string CLandmarkMap2D::asString() const
{
  return "Landmark map with " + std::to_string(landmarks_.size()) + " landmarks";
}

void CLandmarkMap2D::getVisualizationInto(scenes::CSetOfObjects& scene) const
{
  if (genericMapParams.enableSaveAs3DObject) addLandmarks(scene, landmarks_);
}

void CLandmarkMap2D::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
  writeLandmarkCsv(prefix + "_landmarks.csv", landmarks_);
}

double CLandmarkMap2D::internal_computeObservationLikelihood(const mrpt::obs::CObservation& observation,
                                                             const mrpt::poses::CPose3D& robot) const
{
  return observationLogLikelihood(observation, landmarks_, likelihood_options, {robot.x(), robot.y(), robot.yaw()})
      .value_or(0);
}

bool CLandmarkMap2D::internal_canComputeObservationLikelihood(const mrpt::obs::CObservation& observation) const
{
  return toMeasurements(observation).has_value();
}
}  // namespace mrpt_ext
