#include <memory>
#include <ostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/progress_line.h"
#include "mrpt_ext/app/rawlog_output.h"
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

int simulateToFiles(Settings settings, const CommonOptions& options, std::ostream& out)
{
  if (options.seed)
    settings.set("Simulation", "random_seed", std::to_string(*options.seed), "--seed " + std::to_string(*options.seed));
  const Scenario scenario = readScenario(settings);
  const RawlogOutput files = rawlogOutput("landmark-simulator", options.output);

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
  const std::size_t records = writeRawlog(files.rawlog, drive);
  progress.clear();
  const SimulatedDrive driven(scenario);
  const Trajectory poses = driven.truth();
  writeTum(files.truth, poses);
  writeLandmarkCsv(files.map, driven.map());
  if (!options.quiet)
    out << files.rawlog.string() << ": " << records << " records, " << scenario.duration << " s\n"
        << files.truth.string() << ": " << poses.size() << " poses\n"
        << files.map.string() << ": " << driven.map().size() << " landmarks\n";
  return kExitDone;
}
}  // namespace

int runLandmarkSimulator(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err)
{
  AppShell shell({.name = "landmark-simulator",
                  .purpose = "Simulates a robot and writes STEM.rawlog, STEM_ground_truth.tum and STEM_map.csv.",
                  .examples = {"ini/landmark-simulator/room.ini -o out/room.rawlog",
                               "ini/landmark-simulator/kidnap.ini -o out/k.rawlog --set Simulation.duration_s=120"}},
                 out, err);
  fs::path config;
  shell.commandLine().add({.names = "CONFIG",
                           .target = &config,
                           .help = "Scenario, e.g. ini/landmark-simulator/room.ini",
                           .required = true});
  const KeyTable keys = simulatorKeys();
  shell.answerQuestionsAbout(keys);
  return shell.run(arguments,
                   [&] { return simulateToFiles(shell.loadSettings(config, keys), shell.options(), shell.out()); });
}
}  // namespace mrpt_ext
