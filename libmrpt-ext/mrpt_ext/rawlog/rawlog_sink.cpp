#include "mrpt_ext/rawlog/rawlog_sink.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <limits>
#include <set>

#include "mrpt_ext/files/staged_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/physical_limits.h"
#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationRunningFix.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_comment.h"
#include "mrpt_ext/rawlog/rawlog_file_check.h"

namespace mrpt_ext
{
namespace
{
using ObservationPtr = mrpt::obs::CObservation::Ptr;

/// What must be known of all records before the first one is written.
struct LogSummary
{
  std::size_t entries = 0;
  double first_time = 0;                  ///< [s]
  std::set<std::string> ranging_sensors;  ///< that measure at least once what is no bearing
};

class ObservationMaker
{
 public:
  explicit ObservationMaker(std::set<std::string> ranging_sensors) : ranging_sensors_(std::move(ranging_sensors)) {}

  ObservationPtr operator()(const OdometryRecord& odometry) const
  {
    auto observation = mrpt::obs::CObservationOdometry::Create();
    observation->timestamp = timestampOf(odometry.time);
    observation->sensorLabel = "odometry";
    observation->odometry = {odometry.pose.x, odometry.pose.y, odometry.pose.phi};
    return observation;
  }
  ObservationPtr operator()(const Reading& reading) const
  {
    if (ranging_sensors_.count(reading.sensor) > 0) return toStereoRanges(reading);
    return toLandmarkBearings(reading);
  }
  ObservationPtr operator()(const RunningFixReading& fix) const { return toObservation(fix); }
  ObservationPtr operator()(const RangeScan& scan) const { return toObservation(scan); }
  ObservationPtr operator()(const CompassRecord& compass) const
  {
    auto observation = mrpt::obs::CObservationIMU::Create();
    observation->timestamp = timestampOf(compass.time);
    observation->sensorLabel = compass.sensor;
    observation->set(mrpt::obs::IMU_YAW, compass.heading);
    return observation;
  }

 private:
  std::set<std::string> ranging_sensors_;
};

/// Reads all records, and throws where they cannot be written.
LogSummary summaryOf(const std::filesystem::path& path, const RecordStream& records)
{
  LogSummary summary;
  double latest = -std::numeric_limits<double>::infinity();
  for (; const auto record = records(); ++summary.entries)
  {
    const auto fail = [&](const std::string& what)
    { return dataError(path.string() + ": record " + std::to_string(summary.entries) + ": " + what); };
    const double time = timeOf(*record);
    if (const std::string why = whyImpossible(*record); !why.empty()) throw fail(why);
    if (time < latest) throw fail("earlier than the record before it, expected the order of time");
    if (summary.entries == 0) summary.first_time = time;
    latest = time;
    const auto* reading = std::get_if<Reading>(&*record);
    if (reading && reading->sensor.empty()) throw fail("a reading without sensor label");
    if (reading && (hasRange(*reading) || hasFacing(*reading))) summary.ranging_sensors.insert(reading->sensor);
  }
  return summary;
}

void writeTo(const std::filesystem::path& file, const LogSummary& summary, const RecordStream& records,
             const std::string& warning)
{
  mrpt::io::CFileGZOutputStream stream;
  if (!stream.open(file.string())) throw std::runtime_error("cannot be opened");
  auto archive = mrpt::serialization::archiveFrom(stream);
  const ObservationMaker make(summary.ranging_sensors);
  writeComment(archive, commentOf(summary.entries, warning), summary.first_time);
  while (const auto record = records()) archive << *std::visit(make, *record);
}
}  // namespace

void writeRawlog(const std::filesystem::path& path, const Recording& recording, const std::string& warning)
{
  writeRawlog(
      path, [&recording] { return streamOf(recording.records); }, warning);
}

std::size_t writeRawlog(const std::filesystem::path& path, const std::function<RecordStream()>& records,
                        const std::string& warning)
{
  const LogSummary summary = summaryOf(path, records());
  StagedFile staged(path);
  try
  {
    writeTo(staged.path(), summary, records(), warning);
    // Closing does not report a full disk: check the trailing checksum.
    if (!checkRawlogFile(staged.path()).damage.empty()) throw std::runtime_error("incomplete");
  }
  catch (const InputError&)  // of the records
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)  // of MRPT, whose text names a line of its source
  {
    throw dataError(path.string() + ": cannot be written (is the disk full?)");
  }
  staged.commit();
  return summary.entries;
}
}  // namespace mrpt_ext
