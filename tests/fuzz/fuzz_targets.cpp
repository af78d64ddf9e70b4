#include "fuzz_targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/image_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"
#include "mrpt_ext/importers/rosbag2/ros_recording.h"
#include "mrpt_ext/importers/rosbag2/rosbag2_recording.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/report/summary_reader.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
namespace
{
/// A file of the bytes that no disk ever sees.
class MemoryFile
{
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC))
  {
    if (descriptor_ < 0 || write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::logic_error("no file in memory");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void readRawlog(std::string_view bytes)
{
  static const bool registered = (registerAllClasses(), true);
  static_cast<void>(registered);
  const MemoryFile file(bytes);
  RawlogSource source(file.path());
  while (source.next()) continue;
}

void readIni(std::string_view bytes)
{
  const Settings settings = Settings::parse(std::string(bytes), "/data/fuzz.ini", localizationKeys());
  static_cast<void>(Settings::parse(settings.resolvedText(), "/data/again.ini", localizationKeys()));
}

void readMap(std::string_view bytes)
{
  static_cast<void>(readLandmarkCsv(MemoryFile(bytes).path(), {1000, "the test"}));
}
void readFieldLayout(std::string_view bytes)
{
  static_cast<void>(parseFieldLayout(std::string(bytes), "field.json", {1000, "the test"}));
}
void readTagBundle(std::string_view bytes)
{
  static_cast<void>(parseTagBundle(std::string(bytes), "tags.yaml", {1000, "the test"}));
}
void readTruth(std::string_view bytes) { static_cast<void>(readTum(MemoryFile(bytes).path())); }

void readCamera(std::string_view bytes)
{
  const CameraFile camera = CameraFile::read(MemoryFile(bytes).path());
  static_cast<void>(camera.number("width"));
  static_cast<void>(camera.fieldNumber("length"));
  static_cast<void>(camera.centres());
}

void readImage(std::string_view bytes) { static_cast<void>(readImageFile(MemoryFile(bytes).path())); }

void readSummary(std::string_view bytes)
{
  const nlohmann::ordered_json summary = nlohmann::ordered_json::parse(bytes, nullptr, false);
  try
  {
    static_cast<void>(runScoreOf(summary));
  }
  catch (const nlohmann::json::exception&)
  {
    // As its callers take it: not a summary.
  }
}

void readMcapBag(std::string_view bytes)
{
  if (bytes.starts_with("\x89MCAP")) static_cast<void>(importRosbag2({MemoryFile(bytes).path()}, {}));
}

/// sqlite3 follows the link of a file in memory to a name that is none: this one has a name.
void readSqliteFile(std::string_view bytes)
{
  if (!bytes.starts_with("SQLite format 3")) return;
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(getpid()) + ".db3");
  std::ofstream(path, std::ios::binary) << bytes;
  const std::unique_ptr<const std::filesystem::path, void (*)(const std::filesystem::path*)> removed(
      &path, [](const std::filesystem::path* file) { std::filesystem::remove(*file); });
  static_cast<void>(importRosbag2({path}, {}));
}

/// A type, the end of the line, its definition, a zero, and a message.
void readCdrMessage(std::string_view bytes)
{
  const std::size_t line = bytes.find('\n'), zero = bytes.find('\0');
  if (line == std::string_view::npos || zero == std::string_view::npos || line > zero) return;
  const BagTopic topic{"/topic", std::string(bytes.substr(0, line)), "cdr",
                       std::string(bytes.substr(line + 1, zero - line - 1))};
  try
  {
    RosCollector().take({topic, 0, 0, bytes.substr(zero + 1)});
  }
  catch (const DamagedBytes&)
  {
    // As the reader of the file takes it: an error with the place.
  }
}

/// What is refused is fine.
template <FuzzTarget read>
void refusedOrRead(std::string_view bytes)
{
  try
  {
    read(bytes);
  }
  catch (const InputError&)
  {
  }
}
}  // namespace

const std::map<std::string, FuzzTarget>& fuzzTargets()
{
  static const std::map<std::string, FuzzTarget> kTargets{{"rawlog", refusedOrRead<readRawlog>},
                                                          {"ini", refusedOrRead<readIni>},
                                                          {"map", refusedOrRead<readMap>},
                                                          {"tum", refusedOrRead<readTruth>},
                                                          {"camera", refusedOrRead<readCamera>},
                                                          {"image", refusedOrRead<readImage>},
                                                          {"summary", refusedOrRead<readSummary>},
                                                          {"mcap", refusedOrRead<readMcapBag>},
                                                          {"db3", refusedOrRead<readSqliteFile>},
                                                          {"cdr", refusedOrRead<readCdrMessage>},
                                                          {"layout", refusedOrRead<readFieldLayout>},
                                                          {"bundle", refusedOrRead<readTagBundle>}};
  return kTargets;
}
}  // namespace mrpt_ext
