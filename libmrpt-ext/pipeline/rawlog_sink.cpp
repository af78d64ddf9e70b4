#include "mrpt_ext/pipeline/rawlog_sink.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <limits>
#include <set>

#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/pipeline/rawlog_file_check.h"

namespace mrpt_ext
{
namespace
{
using ObservationPtr = mrpt::obs::CObservation::Ptr;
constexpr double kLatestTime = 1e11;  ///< [s] well inside what MRPT's stamps can hold

class ObservationMaker
{
 public:
  explicit ObservationMaker(const Recording& recording)
  {
    for (const Record& record : recording.records)
      if (const auto* reading = std::get_if<Reading>(&record); reading && hasRange(*reading))
        ranging_sensors_.insert(reading->sensor);
  }

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

ObservationPtr countComment(const Recording& recording)
{
  auto comment = mrpt::obs::CObservationComment::Create();
  comment->text = "entries=" + std::to_string(recording.records.size());
  comment->sensorLabel = "entries";
  comment->timestamp = timestampOf(recording.records.empty() ? 0 : timeOf(recording.records.front()));
  return comment;
}

void checkRecords(const std::filesystem::path& path, const Recording& recording)
{
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < recording.records.size(); ++i)
  {
    const std::string where = path.string() + ": record " + std::to_string(i) + ": ";
    const double time = timeOf(recording.records[i]);
    if (!std::isfinite(time) || std::abs(time) > kLatestTime) throw dataError(where + "time is not a finite Unix time");
    if (time < latest) throw dataError(where + "earlier than the record before it, expected the order of time");
    latest = time;
    const auto* reading = std::get_if<Reading>(&recording.records[i]);
    if (reading && reading->sensor.empty()) throw dataError(where + "a reading without sensor label");
  }
}

void writeTo(const std::filesystem::path& file, const Recording& recording)
{
  mrpt::io::CFileGZOutputStream stream;
  if (!stream.open(file.string())) throw std::runtime_error("cannot be opened");
  auto archive = mrpt::serialization::archiveFrom(stream);
  const ObservationMaker make(recording);
  archive << *countComment(recording);
  for (const Record& record : recording.records) archive << *std::visit(make, record);
}
}  // namespace

void writeRawlog(const std::filesystem::path& path, const Recording& recording)
{
  checkRecords(path, recording);
  const std::filesystem::path temporary = temporaryNameFor(path);
  try
  {
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
    writeTo(temporary, recording);
    // Closing does not report a full disk: look whether the checksum at the end is there.
    if (!checkRawlogFile(temporary).damage.empty()) throw std::runtime_error("is the disk full?");
  }
  catch (const std::exception& error)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    const std::string text = error.what();
    throw dataError(path.string() + ": cannot be written (" + text.substr(0, text.find('\n')) + ")");
  }
  renameIntoPlace(temporary, path);
}
}  // namespace mrpt_ext
