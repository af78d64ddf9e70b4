#include "mrpt_ext/app/dataset_app.h"

#include <algorithm>
#include <ostream>

#include "mrpt_ext/diagnosis/range_bias_report.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

const std::map<std::string, IdentityLevel> kIdentities{
    {"known", IdentityLevel::known}, {"category", IdentityLevel::category}, {"anonymous", IdentityLevel::anonymous}};
const std::map<std::string, MeasurementSelection> kMeasurements{{"range-bearing", MeasurementSelection::range_bearing},
                                                                {"bearing", MeasurementSelection::bearing},
                                                                {"range", MeasurementSelection::range}};

template <typename Value>
void addNamed(CLI::App& cli, const std::string& option, Value& target, const std::map<std::string, Value>& values,
              const std::string& help)
{
  cli.add_option_function<std::string>(
         option, [&target, &values](const std::string& name) { target = values.at(name); }, help)
      ->check(CLI::IsMember(values))
      ->type_name("NAME");
}

// STEM_<suffix> for STEM.rawlog.
fs::path besideRawlog(const fs::path& rawlog, const std::string& suffix)
{
  fs::path path = rawlog;
  return path.replace_filename(rawlog.stem().string() + suffix);
}

bool hasReading(const Recording& recording)
{
  return std::any_of(recording.records.begin(), recording.records.end(),
                     [](const Record& record) { return std::holds_alternative<Reading>(record); });
}
}  // namespace

DatasetApp::DatasetApp(std::ostream& out, std::ostream& err)
    : shell_("dataset2rawlog", "Converts recordings of other formats into a rawlog with its map and ground truth", out,
             err)
{
  CLI::App& cli = shell_.cli();
  cli.footer(describeDatasetFormats());
  cli.add_option("FORMAT", request_.format, "Format of the input, see below")->required();
  cli.add_option("INPUT", request_.inputs, "Folder or files, see below")->required();
  cli.add_option("--robot", request_.robot, "Number of the robot (mrclam, mrclam-snapshots)");
  cli.add_option("--map", request_.map, "CSV with the beacons (mrpt-uwb; default: those of the demo)");
  cli.add_option("--truth-origin", truth_origin_,
                 "x y phi_deg of the truth's frame in the map (mrpt-uwb; default 2 4 0)")
      ->expected(3);
  addNamed(cli, "--identity", request_.identity, kIdentities, "What is kept of landmark names (default: known)");
  addNamed(cli, "--measurements", request_.measurements, kMeasurements,
           "What is kept of them (default: range-bearing)");
  cli.add_flag("--examine", examine_, "Tell what the ranges say about the radios, and which lines of an .ini follow");
  cli.add_option("--calibrate", calibrated_, "Also write these lines into this configuration (.ini)");
}

int DatasetApp::run(std::vector<std::string> arguments)
{
  return shell_.run(std::move(arguments), [this] { return convert(); });
}

int DatasetApp::convert()
{
  const fs::path& rawlog = shell_.options().output;
  if (rawlog.extension() != ".rawlog" || rawlog.stem().empty())
    throw configurationError("output '" + rawlog.string() + "', expected -o STEM.rawlog");
  if (!shell_.options().overrides.empty())
    throw configurationError("--set " + shell_.options().overrides.front() + ": dataset2rawlog has no configuration");
  if (!truth_origin_.empty()) request_.truth_origin = {truth_origin_[0], truth_origin_[1], degToRad(truth_origin_[2])};

  const Recording recording = importDataset(request_);
  tell(recording);
  if (!hasReading(recording)) throw dataError(request_.inputs[0].string() + ": holds no reading, nothing was written");
  const std::string calibrated = calibrated_.empty() ? "" : readTextFile(calibrated_);
  write(recording, rawlog);
  if (examine_ || !calibrated_.empty()) examine(recording, calibrated);
  return kExitDone;
}

void DatasetApp::tell(const Recording& recording)
{
  for (const std::string& note : recording.notes)
  {
    if (note.starts_with("warning: "))
      shell_.err() << note << '\n';
    else if (!shell_.options().quiet)
      shell_.out() << note << '\n';
  }
  if (shell_.options().quiet) return;
  for (const std::string& line : describe(recording)) shell_.out() << line << '\n';
}

void DatasetApp::examine(const Recording& recording, const std::string& calibrated)
{
  const RangeBiasReport findings = reportRangeBiases(recording);
  if (!shell_.options().quiet)
  {
    for (const std::string& line : findings.lines) shell_.out() << line << '\n';
    for (const IniAssignment& line : findings.configuration)
      shell_.out() << "set [" << line.section << "] " << line.key << " = " << line.value << '\n';
  }
  if (calibrated_.empty() || findings.configuration.empty()) return;
  writeFileAtomically(calibrated_, withValues(calibrated, findings.configuration));
  if (!shell_.options().quiet) shell_.out() << "wrote " << calibrated_.string() << '\n';
}

void DatasetApp::write(const Recording& recording, const fs::path& rawlog)
{
  const auto tellFile = [this](const fs::path& path)
  {
    if (!shell_.options().quiet) shell_.out() << "wrote " << path.string() << '\n';
    if (shell_.options().verbose) shell_.err() << path.string() << ": " << fs::file_size(path) << " bytes\n";
  };
  const fs::path map = besideRawlog(rawlog, "_map.csv"), truth = besideRawlog(rawlog, "_ground_truth.tum");
  writeRawlog(rawlog, recording);
  tellFile(rawlog);
  writeLandmarkCsv(map, recording.map);
  tellFile(map);
  if (!recording.truth.empty())
  {
    writeTum(truth, recording.truth);
    tellFile(truth);
  }
  else if (fs::remove(truth))  // that of an earlier conversion does not belong to this log
  {
    shell_.err() << truth.string() << ": removed, there is no truth for the new log\n";
  }
}
}  // namespace mrpt_ext
