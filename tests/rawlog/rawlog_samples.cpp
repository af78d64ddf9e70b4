#include "rawlog_samples.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/maps/register_all_classes.h"

namespace mrpt_ext
{
void RawlogTest::SetUp()
{
  registerAllClasses();
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = std::filesystem::path(::testing::TempDir()) /
            (std::string(info->test_suite_name()) + "_" + info->name() + "_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder_);
}

void RawlogTest::TearDown() { std::filesystem::remove_all(folder_); }

namespace
{
Reading cameraReading(double time)
{
  Reading reading{.time = time, .sensor = "camera", .T_robot_sensor = {0.1, 0.0, 0.0}, .sensor_height = 0.4};
  reading.model.has_field_of_view = true;
  reading.model.field_of_view = 2.0;
  reading.model.max_range = 6;
  reading.detections = {{.bearing = std::sin(time), .std_bearing = 0.02},
                        {.category = "pole", .bearing = 0.5, .std_bearing = 0.03}};
  return reading;
}

Reading stereoReading(double time)
{
  Reading reading{.time = time, .sensor = "stereo", .T_robot_sensor = {0.0, 0.2, 0.0}, .horizontal_range = true};
  reading.detections = {{.id = 3, .range = 2 + std::cos(time), .std_range = 0.1},
                        {.id = 4, .bearing = 0.25, .range = 1.5, .std_bearing = 0.01, .std_range = 0.05}};
  return reading;
}

RunningFixReading fixReading(double time)
{
  return {.time = time,
          .first_time = time - 1,
          .sensor = "goal",
          .id = 8,
          .first_range = 1.2,
          .first_std = 0.03,
          .second_range = 1.4,
          .second_std = 0.04,
          .displacement = {0.3, 0.1, 0.05},
          .displacement_covariance = 0.01 * Matrix3d::Identity()};
}
}  // namespace

Recording sampleRecording(int seconds)
{
  Recording recording;
  for (int tick = 0; tick < 10 * seconds; ++tick)
  {
    const double time = 1000 + tick / 10.0;
    recording.records.emplace_back(OdometryRecord{time, {0.05 * tick, std::sin(0.1 * tick), wrap(0.1 * tick)}});
    if (tick % 10 != 9) continue;
    recording.records.emplace_back(cameraReading(time));
    recording.records.emplace_back(stereoReading(time));
    recording.records.emplace_back(CompassRecord{.time = time, .sensor = "compass", .heading = wrap(0.1 * tick)});
    recording.records.emplace_back(fixReading(time));
  }
  return recording;
}

void writeObjects(const std::filesystem::path& path,
                  const std::vector<mrpt::serialization::CSerializable::Ptr>& objects)
{
  mrpt::io::CFileGZOutputStream stream(path.string());
  auto archive = mrpt::serialization::archiveFrom(stream);
  for (const auto& object : objects) archive << *object;
}

std::string readBytes(const std::filesystem::path& path)
{
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

void writeBytes(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string decompress(const std::string& gzip)
{
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  std::string content(gzip.size() * 100 + 1000, '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(gzip.data()));
  stream.avail_in = static_cast<unsigned int>(gzip.size());
  stream.next_out = reinterpret_cast<unsigned char*>(content.data());
  stream.avail_out = static_cast<unsigned int>(content.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  content.resize(stream.total_out);
  inflateEnd(&stream);
  return content;
}

std::string compress(const std::string& content)
{
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string gzip(deflateBound(&stream, content.size()), '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<unsigned int>(content.size());
  stream.next_out = reinterpret_cast<unsigned char*>(gzip.data());
  stream.avail_out = static_cast<unsigned int>(gzip.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  gzip.resize(stream.total_out);
  deflateEnd(&stream);
  return gzip;
}

ReadResult readLog(const std::filesystem::path& path)
{
  ReadResult result;
  try
  {
    RawlogSource source(path);
    while (auto record = source.next()) result.records.push_back(std::move(*record));
    result.statistics = source.statistics();
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(error.kind(), InputError::Kind::data);
    result.error = error.what();
  }
  return result;
}
}  // namespace mrpt_ext
