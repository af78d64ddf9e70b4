#include "fuzz_targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "mrpt_ext/app/live_messages.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/configuration/sensor_sections.h"
#include "mrpt_ext/configuration/simulator_config.h"
#include "mrpt_ext/configuration/simulator_keys.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/front_ends/camera_file.h"
#include "mrpt_ext/front_ends/front_end_factory.h"
#include "mrpt_ext/front_ends/image_file.h"
#include "mrpt_ext/front_ends/images_keys.h"
#include "mrpt_ext/front_ends/tag_dictionary_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/csv_recording.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"
#include "mrpt_ext/importers/rosbag2/ros_recording.h"
#include "mrpt_ext/importers/rosbag2/rosbag2_recording.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/online/online_localizer.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/report/finished_runs.h"
#include "mrpt_ext/report/study_table.h"
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

/// A folder of this process, gone with it.
const std::filesystem::path& ownFolder()
{
  static const struct Folder
  {
    Folder() : path(std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(getpid())))
    {
      std::filesystem::create_directory(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path;
  } kFolder;
  return kFolder.path;
}

void readRawlog(std::string_view bytes)
{
  static const bool registered = (registerAllClasses(), true);
  static_cast<void>(registered);
  const MemoryFile file(bytes);
  RawlogSource source(file.path());
  while (source.next()) continue;
}

const LandmarkTable& twoLandmarks()
{
  static const LandmarkTable kMap({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {5, 4, 0}}});
  return kMap;
}

/// Its lines, then what its values mean.
void readIni(std::string_view bytes)
{
  static const KeyTable kKeys = localizationKeys();
  const Settings settings = Settings::parse(std::string(bytes), "/data/fuzz.ini", kKeys);
  static_cast<void>(Settings::parse(settings.resolvedText(), "/data/again.ini", kKeys));
  static_cast<void>(sensorConfigs(settings));
  static_cast<void>(localizationConfig(settings, twoLandmarks()));
}

void readScenarioIni(std::string_view bytes)
{
  static const KeyTable kKeys = simulatorKeys();
  static_cast<void>(readScenario(Settings::parse(std::string(bytes), "/data/fuzz.ini", kKeys)));
}

void readImagesIni(std::string_view bytes)
{
  static const KeyTable kKeys = imagesKeys();
  static_cast<void>(makeFrontEnd(Settings::parse(std::string(bytes), "/data/fuzz.ini", kKeys), {}));
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
  static const std::vector<Settings> kSensors = []
  {
    std::vector<Settings> sensors;
    for (const char* const name : {"conic_mirror", "movis", "stereo_goal", "tags"})
      sensors.push_back(
          Settings::parse(std::string("[Images]\nsensor = ") + name + '\n', "/data/fuzz.ini", imagesKeys()));
    return sensors;
  }();
  const CameraFile camera = CameraFile::read(MemoryFile(bytes).path());
  for (const Settings& sensor : kSensors) try
    {
      static_cast<void>(makeFrontEnd(sensor, camera));
    }
    catch (const InputError&)
    {
      // Refused by this sensor, perhaps not by the next.
    }
}

void readDictionary(std::string_view bytes) { static_cast<void>(readTagDictionary(MemoryFile(bytes).path())); }

void readImage(std::string_view bytes) { static_cast<void>(readImageFile(MemoryFile(bytes).path())); }

/// As `localization-report` and `--resume` read it.
void readSummary(std::string_view bytes)
{
  std::ofstream(ownFolder() / "summary.json", std::ios::binary) << bytes;
  static_cast<void>(readTrialScore(ownFolder(), {}, 0));
  static_cast<void>(studyMarkdown(readFinishedRuns({ownFolder()})));
}

/// Lines of a program that drives `landmark-localization --live`.
void readLiveLines(std::string_view bytes)
{
  static const OnlineOptions kOptions =
      onlineOptions(localizationConfig(Settings::parse("", "/data/fuzz.ini", localizationKeys()), twoLandmarks()));
  OnlineLocalizer robot(kOptions, twoLandmarks());
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) try
    {
      applyLiveLine(line, robot);
    }
    catch (const InputError&)
    {
      // Told, and the next line counts.
    }
}

/// Landmarks, odometry and detections, each behind a form feed.
void readCsvRecording(std::string_view bytes)
{
  CsvFiles files{ownFolder() / "landmarks.csv", ownFolder() / "odometry.csv", ownFolder() / "detections.csv"};
  for (const std::filesystem::path& file : {files.landmarks, files.odometry, files.detections})
  {
    std::ofstream(file, std::ios::binary) << bytes.substr(0, bytes.find('\f'));
    bytes.remove_prefix(std::min(bytes.size(), bytes.find('\f')));
    if (!bytes.empty()) bytes.remove_prefix(1);
  }
  files.wheelbase = 1;
  static_cast<void>(importCsv(files));
}

void readMcapBag(std::string_view bytes)
{
  if (bytes.starts_with("\x89MCAP")) static_cast<void>(importRosbag2({MemoryFile(bytes).path()}, {}));
}

/// sqlite3 follows the link of a file in memory to a name that is none: this one has a name.
void readSqliteFile(std::string_view bytes)
{
  if (!bytes.starts_with("SQLite format 3")) return;
  const std::filesystem::path path = ownFolder() / "bag.db3";
  std::ofstream(path, std::ios::binary) << bytes;
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
                                                          {"scenario", refusedOrRead<readScenarioIni>},
                                                          {"images_ini", refusedOrRead<readImagesIni>},
                                                          {"live", refusedOrRead<readLiveLines>},
                                                          {"csv", refusedOrRead<readCsvRecording>},
                                                          {"map", refusedOrRead<readMap>},
                                                          {"tum", refusedOrRead<readTruth>},
                                                          {"camera", refusedOrRead<readCamera>},
                                                          {"dictionary", refusedOrRead<readDictionary>},
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
