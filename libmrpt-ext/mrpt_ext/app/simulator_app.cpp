#include "mrpt_ext/app/simulator_app.h"

#include <memory>
#include <ostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/progress_line.h"
#include "mrpt_ext/configuration/simulator_config.h"
#include "mrpt_ext/configuration/simulator_keys.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "mrpt_ext/simulation/simulated_drive.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

fs::path beside(const fs::path& rawlog, const std::string& ending)
{
  return rawlog.parent_path() / (rawlog.stem().string() + ending);
}

void checkOutput(const fs::path& rawlog)
{
  if (rawlog.empty()) throw configurationError("landmark-simulator: -o/--output is missing, expected STEM.rawlog");
  if (rawlog.extension() != ".rawlog")
    throw configurationError("landmark-simulator: --output " + rawlog.string() + ": expected a name ending in .rawlog");
}

int simulateToFiles(const fs::path& config, const CommonOptions& options, std::ostream& out)
{
  Settings settings = Settings::load(config, simulatorKeys(), options.overrides);
  if (options.seed)
    settings.set("Simulation", "random_seed", std::to_string(*options.seed), "--seed " + std::to_string(*options.seed));
  const Scenario scenario = readScenario(settings);
  checkOutput(options.output);

  ProgressLine progress(!options.quiet, "simulating");
  const auto drive = [&, passes = 0]() mutable -> RecordStream
  {
    const double before = passes++ / 2.0;  // one pass to count the records, one to write them
    return [&, before, drive = std::make_shared<SimulatedDrive>(scenario)]
    {
      auto record = drive->next();
      if (record) progress.show(before + (timeOf(*record) - scenario.start_time) / scenario.duration / 2);
      return record;
    };
  };
  const fs::path truth = beside(options.output, "_ground_truth.tum"), map = beside(options.output, "_map.csv");
  const std::size_t records = writeRawlog(options.output, drive);
  progress.clear();
  const SimulatedDrive driven(scenario);
  const Trajectory poses = driven.truth();
  writeTum(truth, poses);
  writeLandmarkCsv(map, driven.map());
  if (!options.quiet)
    out << options.output.string() << ": " << records << " records, " << scenario.duration << " s\n"
        << truth.string() << ": " << poses.size() << " poses\n"
        << map.string() << ": " << driven.map().size() << " landmarks\n";
  return kExitDone;
}
}  // namespace

int SimulatorApp::run(const std::vector<std::string>& arguments)
{
  AppShell shell("landmark-simulator",
                 "Plays the scenario of an .ini file and writes STEM.rawlog, STEM_ground_truth.tum and STEM_map.csv.",
                 out_, err_);
  fs::path config;
  shell.cli().add_option("CONFIG", config, "Scenario, e.g. ini/landmark-simulator/room.ini")->required();
  shell.answerQuestionsAbout(simulatorKeys());
  return shell.run(arguments, [&] { return simulateToFiles(config, shell.options(), out_); });
}
}  // namespace mrpt_ext
