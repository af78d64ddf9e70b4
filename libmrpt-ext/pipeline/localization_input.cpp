#include "mrpt_ext/pipeline/localization_input.h"

#include <algorithm>
#include <set>

#include "mrpt_ext/evaluation/scoring.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/mrpt_index_truth.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/pipeline/method_factory.h"
#include "mrpt_ext/pipeline/sha256.h"

namespace mrpt_ext
{
namespace
{
const std::string kExperiment = "LocalizationExperiment";
const std::string kMapSection = "MetricMap_landmarkMap2D_00_creationOpts";
constexpr double kSparseGap = 0.5;  // [s] truth that is mostly further apart cannot be interpolated

std::filesystem::path requiredPath(const Settings& settings, const std::string& section, const std::string& key,
                                   const std::string& option)
{
  if (settings.hasValue(section, key)) return settings.path(section, key);
  throw configurationError(settings.file().string() + ": [" + section + "] " + key + " is not set, set it or give " +
                           option);
}

LandmarkTable loadMap(const Settings& settings)
{
  const auto path = requiredPath(settings, kMapSection, "landmarks_file", "--map FILE");
  LandmarkTable map = readLandmarkCsv(path);
  if (map.empty()) throw configurationError(path.string() + ": holds no landmark, at least one is needed");
  return map;
}

std::vector<Record> readWindow(RawlogSource& source, const LogWindow& window)
{
  std::vector<Record> records = readAll(source);
  if (records.empty()) return records;
  const double from = timeOf(records.front()) + window.start;
  const double to = window.duration ? from + *window.duration : std::numeric_limits<double>::infinity();
  std::erase_if(records, [&](const Record& record) { return timeOf(record) < from || timeOf(record) > to; });
  return records;
}

Trajectory indexedTruth(const Settings& settings, const std::filesystem::path& path, const RawlogSource& source)
{
  const std::vector<double> origin = settings.numbers(kExperiment, "ground_truth_origin");
  if (origin.size() != 3)
    throw settings.errorAt(kExperiment, "ground_truth_origin", "expected three numbers: x y phi_deg");
  if (source.stepTimes().empty())
    throw configurationError(path.string() +
                             ": ground_truth_format = mrpt-index needs a log of actions and sensory "
                             "frames, this one has observations only");
  Trajectory truth;
  for (const auto& [step, pose] : readMrptIndexTruth(path, {origin[0], origin[1], degToRad(origin[2])}))
    if (step >= 0 && static_cast<std::size_t>(step) < source.stepTimes().size())
      truth.push_back({source.stepTimes()[static_cast<std::size_t>(step)], pose, true});
  // Steps without a time of their own share the stamp before them; one pose per stamp is enough.
  std::stable_sort(truth.begin(), truth.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  truth.erase(std::unique(truth.begin(), truth.end(), [](const auto& a, const auto& b) { return a.time == b.time; }),
              truth.end());
  return truth;
}

Trajectory loadTruth(const Settings& settings, const RawlogSource& source)
{
  if (!settings.hasValue(kExperiment, "ground_truth_path_file")) return {};
  const auto path = settings.path(kExperiment, "ground_truth_path_file");
  const bool indexed =
      settings.choice(kExperiment, "ground_truth_format") == "mrpt-index" && path.extension() != ".tum";
  if (indexed) return indexedTruth(settings, path, source);
  return readTum(path);
}

bool isSparse(const Trajectory& truth)
{
  std::size_t long_gaps = 0;
  for (std::size_t i = 1; i < truth.size(); ++i)
    if (truth[i].time - truth[i - 1].time > kSparseGap) ++long_gaps;
  return 2 * long_gaps > truth.size();
}

/// The files beside the log, with what tells whether they are still the same.
std::vector<InputFile> inputFiles(const Settings& settings)
{
  std::vector<InputFile> files{{"configuration", settings.file().string(), {}},
                               {"map", settings.path(kMapSection, "landmarks_file").string(), {}}};
  if (settings.hasValue(kExperiment, "ground_truth_path_file"))
    files.push_back({"truth", settings.path(kExperiment, "ground_truth_path_file").string(), {}});
  for (InputFile& file : files) file.sha256 = sha256OfFile(file.path);
  return files;
}

/// Compares the labels of the configuration with those of the records.
void matchSensors(LocalizationInput& input, const std::vector<Record>& records)
{
  std::set<std::string> logged;
  const auto collect = [&](const auto& record)
  {
    if constexpr (requires { record.sensor; }) logged.insert(record.sensor);
  };
  for (const Record& record : records) std::visit(collect, record);
  input.logged_sensors.assign(logged.begin(), logged.end());
  for (const auto& [label, config] : input.config.frames.sensors)
    if (logged.count(label) == 0) input.unmatched_sensors.push_back(label);
}

void checkAnythingToScore(const LocalizationInput& input)
{
  if (input.sequence.detections > 0) return;
  std::string seen;
  for (const auto& [name, count] : input.context.observations)
    seen += (seen.empty() ? "" : ", ") + std::to_string(count.total) + " " + name;
  for (const auto& [reason, count] : input.unusable) seen += "; " + std::to_string(count) + " " + reason;
  throw dataError(input.context.rawlog_path + ": no observation in it can be scored against the map (it has " +
                  (seen.empty() ? "none" : seen) + ")");
}
}  // namespace

LocalizationInput loadLocalization(const Settings& settings, const LogWindow& window)
{
  LocalizationInput input;
  input.context.map = loadMap(settings);
  input.config = localizationConfig(settings, input.context.map);
  const auto rawlog = requiredPath(settings, kExperiment, "rawlog_file", "RAWLOG");
  RawlogSource source(rawlog);
  const std::vector<Record> records = readWindow(source, window);
  const RawlogStatistics statistics = source.statistics();
  input.context.config_path = settings.file().string();
  input.context.rawlog_path = rawlog.string();
  input.context.rawlog_sha256 = source.sha256();
  input.context.rawlog_entries = statistics.entries;
  input.context.observations = statistics.observations;
  if (!records.empty())
  {
    input.context.start_time = timeOf(records.front());
    input.context.duration_s = timeOf(records.back()) - timeOf(records.front());
  }
  input.sequence = buildFrames(records, input.context.map, input.config.frames);
  input.unusable = statistics.unusable;
  for (const auto& [reason, count] : input.sequence.unusable) input.unusable[reason] += count;
  checkAnythingToScore(input);
  matchSensors(input, records);
  (void)MethodFactory(input.config, input.context.map, input.sequence);  // an unknown name is told before the work
  input.context.truth = loadTruth(settings, source);
  input.context.truth_is_sparse = isSparse(input.context.truth);
  input.context.inputs = inputFiles(settings);
  input.context.geometry = frameGeometry(input.sequence.frames, input.context.map, input.context.truth,
                                         input.context.truth_is_sparse ? 0.0 : kMaxTruthGap);
  return input;
}
}  // namespace mrpt_ext
