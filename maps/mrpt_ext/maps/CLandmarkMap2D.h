#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/maps/landmark_likelihood_options.h"
#include "mrpt_ext/observations/mrpt_compatibility.h"

namespace mrpt_ext
{
/// Known landmarks as an MRPT map, declared as `landmarkMap2D` in an .ini:
///
///     [MetricMap]
///     landmarkMap2D_count = 1
///     [MetricMap_landmarkMap2D_00_creationOpts]
///     landmarks_file = room_map.csv          ; see landmark_file.h for the search path
///     [MetricMap_landmarkMap2D_00_likelihoodOpts]
///     clutter_probability = 0.05             ; see landmark_likelihood_options.h
///
/// Scores our observation classes and MRPT's CObservationBearingRange and CObservationBeaconRanges, by id, by category
/// or anonymously. Scoring is const and may run in several threads at once. The map is given, never learned:
/// inserting an observation does nothing and returns false.
class CLandmarkMap2D : public mrpt::maps::CMetricMap
{
  DEFINE_SERIALIZABLE(CLandmarkMap2D, mrpt_ext)

 public:
  CLandmarkMap2D() = default;
  explicit CLandmarkMap2D(LandmarkTable landmarks) : landmarks_(std::move(landmarks)) {}

  LandmarkLikelihoodOptions likelihood_options;

  [[nodiscard]] const LandmarkTable& landmarks() const { return landmarks_; }

  bool isEmpty() const override { return landmarks_.empty(); }
  std::string asString() const override;
  /// Adds a ball and the id for each landmark, an ellipse of three sigma where its position is uncertain.
  void getVisualizationInto(scenes::CSetOfObjects& scene) const override;
  /// Writes `<prefix>_landmarks.csv`.
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;

 private:
  void internal_clear() override { landmarks_ = {}; }
  bool internal_insertObservation(const mrpt::obs::CObservation&,
                                  const std::optional<const mrpt::poses::CPose3D>&) override
  {
    return false;
  }
  double internal_computeObservationLikelihood(const mrpt::obs::CObservation& observation,
                                               const mrpt::poses::CPose3D& robot) const override;
  bool internal_canComputeObservationLikelihood(const mrpt::obs::CObservation& observation) const override;

  LandmarkTable landmarks_;

  MAP_DEFINITION_START(CLandmarkMap2D)
  std::string landmarks_file;
  LandmarkLikelihoodOptions likelihood_options;
  MAP_DEFINITION_END(CLandmarkMap2D)
};

/// Log-likelihood of the landmark measurements of an observation, for one robot pose; always finite.
/// Running fixes count as two ranges (running_fix_likelihood.h); unusable detections do not count.
/// Nothing for a class without landmark measurements.
[[nodiscard]] std::optional<double> observationLogLikelihood(const mrpt::obs::CObservation& observation,
                                                             const LandmarkTable& landmarks,
                                                             const LandmarkLikelihoodOptions& options,
                                                             const Pose2& robot);
}  // namespace mrpt_ext
