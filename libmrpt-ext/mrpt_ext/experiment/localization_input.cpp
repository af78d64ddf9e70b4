#include "mrpt_ext/experiment/localization_input.h"

#include <algorithm>
#include <memory>
#include <set>

#include "mrpt_ext/configuration/configured_files.h"
#include "mrpt_ext/evaluation/scoring.h"
#include "mrpt_ext/experiment/log_adaptation.h"
#include "mrpt_ext/experiment/method_factory.h"
#include "mrpt_ext/files/mrpt_index_truth.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/frames/log_overview.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/rawlog_comment.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/rawlog/sha256.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSparseGap = 0.5;  // [s] truth that is mostly further apart cannot be interpolated

/// Tells the sensors from whose laser scans something is extracted. `sensors` must outlive what is returned.
std::function<bool(const std::string&)> usedScans(const SensorConfigs& sensors)
{
  const bool any =
      std::any_of(sensors.begin(), sensors.end(), [](const auto& s) { return s.second.reflectors.has_value(); });
  if (!any) return {};
  return [&sensors](const std::string& label) { return configOf(sensors, label).reflectors.has_value(); };
}

/// The records within the window; `source` must outlive them.
RecordStream recordsOf(RawlogSource& source, const LogWindow& window)
{
  return [&source, window, from = std::optional<double>()]() mutable -> std::optional<Record>
  {
    while (auto record = source.next())
    {
      const double time = timeOf(*record);
      if (!from) from = time + window.start;
      if (window.duration && time > *from + *window.duration) break;
      if (time >= *from) return record;
    }
    return std::nullopt;
  };
}

Trajectory indexedTruth(const Settings& settings, const std::filesystem::path& path, const RawlogSource& source)
{
  const std::vector<double> origin = settings.numbers(kExperimentSection, "ground_truth_origin");
  if (origin.size() != 3)
    throw settings.errorAt(kExperimentSection, "ground_truth_origin", "expected three numbers: x y phi_deg");
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
  if (!settings.hasValue(kExperimentSection, "ground_truth_path_file")) return {};
  const auto path = settings.existingPath(kExperimentSection, "ground_truth_path_file");
  const bool indexed =
      settings.choice(kExperimentSection, "ground_truth_format") == "mrpt-index" && path.extension() != ".tum";
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

/// The files beside the log, with their checksums.
std::vector<InputFile> inputFiles(const Settings& settings)
{
  std::vector<InputFile> files{{"map", settings.path(kMapSection, "landmarks_file").string(), {}}};
  if (std::filesystem::exists(settings.file()))  // else it is the built-in one
    files.insert(files.begin(), {"configuration", settings.file().string(), {}});
  if (settings.hasValue(kExperimentSection, "ground_truth_path_file"))
    files.push_back({"truth", settings.path(kExperimentSection, "ground_truth_path_file").string(), {}});
  for (InputFile& file : files) file.sha256 = sha256OfFile(file.path);
  return files;
}

/// Compares the labels of the configuration with those of the records.
void matchSensors(LocalizationInput& input, const std::set<std::string>& logged)
{
  input.logged_sensors.assign(logged.begin(), logged.end());
  for (const auto& [label, config] : input.config.frames.sensors)
    if (logged.count(label) == 0) input.unmatched_sensors.push_back(label);
}

/// First pass: properties of the log as a whole.
void readOverview(LocalizationInput& input, RawlogSource& source)
{
  RunContext& context = input.context;
  std::optional<double> first, last;
  std::set<std::string> sensors;
  const auto collect = [&](const auto& record)
  {
    if constexpr (requires { record.sensor; }) sensors.insert(record.sensor);
  };
  const RecordStream records = recordsOf(source, input.log.window);
  const auto observed = [&]
  {
    auto record = records();
    if (!record) return record;
    last = timeOf(*record);
    if (!first) first = last;
    std::visit(collect, *record);
    return record;
  };
  input.log.overview = overviewOf(observed, input.config.frames.odometry);
  while (source.next()) continue;  // damage and counts concern the whole log
  if (first) context.start_time = *first;
  if (first) context.duration_s = *last - *first;
  matchSensors(input, sensors);
  const RawlogStatistics statistics = source.statistics();
  context.rawlog_sha256 = source.sha256();
  context.rawlog_entries = statistics.entries;
  context.observations = statistics.observations;
  input.unusable = statistics.unusable;
  input.gaps = statistics.gaps;
}

void expectFewDetections(const LocalizationInput& input, const Frame& frame)
{
  std::size_t detections = 0;
  for (const Reading& reading : frame.readings) detections += reading.detections.size();
  if (detections <= input.config.max_detections) return;
  throw dataError(input.context.rawlog_path + ": frame at " + fixedText(frame.time, 3) +
                  " s: " + std::to_string(detections) + " detections, expected at most " +
                  std::to_string(input.config.max_detections) + ": set [" + kExperimentSection + "] max_detections");
}

/// Second pass: properties of the frames.
void readFrames(LocalizationInput& input)
{
  const RunContext& context = input.context;
  const double max_gap = context.truth_is_sparse ? 0.0 : kMaxTruthGap;
  FrameLog& log = input.log;
  log.available.odometry = !log.overview.odometry.empty();
  FrameSynchronizer frames = framesOf(input);
  while (const auto frame = frames.next())
  {
    static_cast<void>(frames.takeObjectFrames());
    expectFewDetections(input, *frame);
    ++log.frames;
    log.available.add(*frame);
    log.reach.add(*frame, context.map);
    log.extent.add(*frame);
    if (const auto geometry = frameGeometry(*frame, context.map, context.truth, max_gap))
      input.context.geometry.push_back(*geometry);
  }
  log.detections = frames.detections();
  for (const auto& [reason, count] : frames.unusable()) input.unusable[reason] += count;
}

void checkAnythingToScore(const LocalizationInput& input)
{
  if (input.log.detections > 0) return;
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
  input.context.map = configuredMap(settings);
  input.config = localizationConfig(settings, input.context.map);
  input.log.path = requiredPath(settings, kExperimentSection, "rawlog_file", "RAWLOG");
  input.log.window = window;
  input.context.config_path = settings.file().string();
  input.context.rawlog_path = input.log.path.string();
  RawlogSource source(input.log.path, input.config.step, usedScans(input.config.frames.sensors));
  if (source.hasSensoryFrames()) input.config.frames.window = 0;
  if (!source.clockNote().empty()) input.notes.push_back(source.clockNote());
  readOverview(input, source);
  input.warning = statedWarning(source.comment());
  input.context.odometry = input.log.overview.odometry.trajectory();
  input.context.truth = loadTruth(settings, source);
  input.context.truth_is_sparse = isSparse(input.context.truth);
  readFrames(input);
  checkAnythingToScore(input);
  adaptToLog(input.config, {input.log.available, input.log.reach, input.log.extent, input.context.duration_s},
             input.notes);
  (void)MethodFactory(input.config, input.context.map,
                      input.log.available);  // reports an unknown method before the work
  input.context.inputs = inputFiles(settings);
  return input;
}

RecordStream loggedRecords(const Settings& settings, const LogWindow& window)
{
  const auto source =
      std::make_shared<RawlogSource>(requiredPath(settings, kExperimentSection, "rawlog_file", "RAWLOG"),
                                     settings.number(kExperimentSection, "step_s"));
  return [source, next = recordsOf(*source, window)] { return next(); };
}

namespace
{
FrameSynchronizer framesOf(const LocalizationInput& input, const FrameOptions& options)
{
  const auto source =
      std::make_shared<RawlogSource>(input.log.path, input.config.step, usedScans(input.config.frames.sensors));
  const auto records = [source, next = recordsOf(*source, input.log.window)] { return next(); };
  return {records, input.context.map, options, input.log.overview};
}
}  // namespace

FrameSynchronizer framesOf(const LocalizationInput& input) { return framesOf(input, input.config.frames); }

FrameStream streamOf(const LocalizationInput& input) { return streamOf(input, input.config.frames); }

FrameStream streamOf(const LocalizationInput& input, const FrameOptions& options)
{
  return [synchronizer = std::make_shared<FrameSynchronizer>(framesOf(input, options))]
  {
    static_cast<void>(synchronizer->takeObjectFrames());
    return synchronizer->next();
  };
}
}  // namespace mrpt_ext
