#include <algorithm>
#include <ostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/calibrated_file.h"
#include "mrpt_ext/app/dataset_formats.h"
#include "mrpt_ext/app/rawlog_output.h"
#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/diagnosis/range_bias_report.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

/// The options as given, before they become a DatasetRequest.
struct DatasetOptions
{
  DatasetRequest request;
  std::vector<double> truth_origin;  ///< x y phi_deg
  std::string identity, measurements;
  bool diagnose = false;
  fs::path calibrated;
};

NamedValues<MeasurementSelection> measurementSelections()
{
  return {{MeasurementSelection::range_bearing, {"range-bearing"}},
          {MeasurementSelection::bearing, {"bearing"}},
          {MeasurementSelection::range, {"range"}}};
}

template <typename Value>
std::vector<std::string> wordsOf(const NamedValues<Value>& values)
{
  std::vector<std::string> words;
  for (const auto& [value, choice] : values) words.push_back(choice.name);
  return words;
}

bool hasReading(const Recording& recording)
{
  return std::any_of(recording.records.begin(), recording.records.end(),
                     [](const Record& record)
                     { return std::holds_alternative<Reading>(record) || std::holds_alternative<RangeScan>(record); });
}

void addOptions(CommandLine& line, DatasetOptions& options)
{
  DatasetRequest& request = options.request;
  line.add({.names = "FORMAT", .target = &request.format, .help = "Format of the input, see below", .required = true})
      .add({.names = "INPUT", .target = &request.inputs, .help = "Folder or files, see below", .required = true})
      .add({.names = "--robot", .target = &request.robot, .help = "Number of the robot (mrclam, mrclam-snapshots)"})
      .add({.names = "--wheelbase",
            .target = &request.wheelbase,
            .help = "Distance of the axles in metres (csv, with steering_rad in odometry.csv)",
            .numbers = AllowedNumbers::positive})
      .add({.names = "--wheel-offset",
            .target = &request.wheel_offset,
            .help = "How far to the left of the axle's middle the wheel is that measures the speed [m] (csv)"})
      .add({.names = "--map",
            .target = &request.map,
            .help = "The landmarks (rosbag2), the beacons (mrpt-uwb; default: those of the demo)"})
      .add({.names = "--topic",
            .target = &request.topics,
            .help = "ROLE=NAME, may be repeated: the topic for odometry, truth, detections or scan, or none (rosbag2)",
            .values = 1})
      .add({.names = "--base",
            .target = &request.base,
            .help = "The robot's frame: a frame of the bag (rosbag2), a sensor of sensors.csv (csv)"})
      .add({.names = "--truth-origin",
            .target = &options.truth_origin,
            .help = "x y phi_deg of the truth's frame in the map (mrpt-uwb; default 2 4 0)",
            .values = 3})
      .add({.names = "--identity",
            .target = &options.identity,
            .help = "Which identities of landmarks are kept (default: known)",
            .choices = wordsOf(identityLevels())})
      .add({.names = "--measurements",
            .target = &options.measurements,
            .help = "Which measurements are kept (default: range-bearing)",
            .choices = wordsOf(measurementSelections())})
      .add({.names = "--diagnose",
            .target = &options.diagnose,
            .help = "Estimate the range bias of every radio; print the suggested .ini lines"})
      .add({.names = "--examine", .target = &options.diagnose, .help = "--diagnose", .hidden = true})
      .add({.names = "--calibrate",
            .target = &options.calibrated,
            .help = "Also write these lines into this configuration (.ini)"});
}

/// One conversion: reads, reports, writes.
class Conversion
{
 public:
  Conversion(AppShell& shell, DatasetOptions options) : shell_(shell), options_(std::move(options)) {}

  int run()
  {
    const RawlogOutput files = rawlogOutput("dataset2rawlog", shell_.options().output, options_.request.inputs);
    if (const auto& overrides = shell_.options().overrides; !overrides.empty())
      throw configurationError("--set " + overrides.front() + ": dataset2rawlog has no configuration");
    DatasetRequest request = options_.request;
    if (const auto& origin = options_.truth_origin; !origin.empty())
      request.truth_origin = {origin[0], origin[1], degToRad(origin[2])};
    if (!options_.identity.empty()) request.identity = namedValue(options_.identity, identityLevels());
    if (!options_.measurements.empty())
      request.measurements = namedValue(options_.measurements, measurementSelections());
    const std::string ini = options_.calibrated.empty() ? "" : readFileToCalibrate(options_.calibrated);

    const Recording recording = importDataset(request);
    printNotes(recording);
    if (!hasReading(recording)) throw dataError(request.inputs[0].string() + ": holds no reading, nothing was written");
    write(recording, files);
    if (options_.diagnose || !ini.empty()) diagnose(recording, ini);
    return kExitDone;
  }

 private:
  void print(const std::string& line)
  {
    if (!shell_.options().quiet) shell_.out() << line << '\n';
  }

  void printNotes(const Recording& recording)
  {
    for (const std::string& note : recording.notes)
    {
      if (note.starts_with("warning: "))
        shell_.err() << note << '\n';
      else
        print(note);
    }
    for (const std::string& line : describe(recording)) print(line);
  }

  /// `ini`: text of the configuration to write into.
  void diagnose(const Recording& recording, const std::string& ini)
  {
    const RangeBiasReport findings = reportRangeBiases(recording);
    for (const std::string& line : findings.lines) print(line);
    for (const IniAssignment& line : findings.configuration)
      print("set [" + line.section + "] " + line.key + " = " + line.value);
    if (options_.calibrated.empty() || findings.configuration.empty()) return;
    writeFileAtomically(options_.calibrated, withValues(ini, findings.configuration));
    print("wrote " + options_.calibrated.string());
  }

  void printWritten(const fs::path& path)
  {
    print("wrote " + path.string());
    if (shell_.options().verbose) shell_.err() << path.string() << ": " << fs::file_size(path) << " bytes\n";
  }

  void write(const Recording& recording, const RawlogOutput& files)
  {
    writeRawlog(files.rawlog, recording);
    printWritten(files.rawlog);
    writeLandmarkCsv(files.map, recording.map);
    printWritten(files.map);
    if (!recording.truth.empty())
    {
      writeTum(files.truth, recording.truth);
      printWritten(files.truth);
    }
    else if (fs::remove(files.truth))  // that of an earlier conversion does not belong to this log
    {
      shell_.err() << files.truth.string() << ": removed, there is no truth for the new log\n";
    }
  }

  AppShell& shell_;
  DatasetOptions options_;
};
}  // namespace

int runDataset2Rawlog(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err)
{
  AppShell shell({.name = "dataset2rawlog",
                  .purpose = "Converts recordings of other formats into a rawlog with its map and ground truth",
                  .examples = {"csv my_folder -o out/csv.rawlog", "mrclam MRCLAM_Dataset6 --robot 1 -o out/r1.rawlog"},
                  .more = describeDatasetFormats()},
                 out, err);
  DatasetOptions options;
  addOptions(shell.commandLine(), options);
  return shell.run(arguments, [&] { return Conversion(shell, options).run(); });
}
}  // namespace mrpt_ext
