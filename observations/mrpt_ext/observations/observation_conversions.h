#pragma once

#include <mrpt/obs/obs_frwds.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/range_scan.h"

namespace mrpt::rtti
{
class CObject;
}  // namespace mrpt::rtti

/// Conversion between the classes of a log and the plain values of solvers, likelihoods and filters.
/// Sensor poses become planar: x, y, yaw and the height; pitch and roll are not used. A declared value of 0 (field of
/// view, range limit, standard deviation) means "not declared" in the log and stays so. Nothing is checked here: see
/// usable_detections.h.
namespace mrpt_ext
{
class CObservationLandmarkBearings;
class CObservationRunningFix;
class CObservationStereoRanges;

[[nodiscard]] Reading toReading(const CObservationLandmarkBearings& observation);
[[nodiscard]] Reading toReading(const CObservationStereoRanges& observation);

/// MRPT's range and bearing. Its range has no "absent" mark: 0 is read as not measured. Its field of view counts as
/// declared only together with a range limit, because the class presets 180 degrees and no limit.
[[nodiscard]] Reading toReading(const mrpt::obs::CObservationBearingRange& observation);

/// MRPT's ranges to beacons: one reading per antenna position.
[[nodiscard]] std::vector<Reading> toReadings(const mrpt::obs::CObservationBeaconRanges& observation);

[[nodiscard]] RunningFixReading toRunningFix(const CObservationRunningFix& observation);

/// The landmark measurements of an observation.
struct LandmarkMeasurements
{
  std::vector<Reading> readings;
  std::vector<RunningFixReading> fixes;
};

/// The measurements of any observation; nothing for a class without landmark measurements.
[[nodiscard]] std::optional<LandmarkMeasurements> toMeasurements(const mrpt::obs::CObservation& observation);

/// A laser scan. Its intensities are whole numbers.
[[nodiscard]] RangeScan toRangeScan(const mrpt::obs::CObservation2DRangeScan& observation);

/// Name of the class without its namespace.
[[nodiscard]] std::string shortClassName(const mrpt::rtti::CObject& object);

/// The observation's label, or, when it is empty, a stable one derived from its class ("beacons", "bearings", ...).
[[nodiscard]] std::string labelOf(const mrpt::obs::CObservation& observation);

/// The reverse; the first one represents bearings alone: see hasRange(), hasFacing().
[[nodiscard]] std::shared_ptr<CObservationLandmarkBearings> toLandmarkBearings(const Reading& reading);
[[nodiscard]] std::shared_ptr<CObservationStereoRanges> toStereoRanges(const Reading& reading);
[[nodiscard]] std::shared_ptr<CObservationRunningFix> toObservation(const RunningFixReading& fix);
/// MRPT's scans are symmetric about the forward axis: the sensor pose is turned to the middle of the scan.
[[nodiscard]] std::shared_ptr<mrpt::obs::CObservation2DRangeScan> toObservation(const RangeScan& scan);

/// True if any detection has a range.
[[nodiscard]] bool hasRange(const Reading& reading);
/// True if any detection tells which way its landmark faces.
[[nodiscard]] bool hasFacing(const Reading& reading);
}  // namespace mrpt_ext
