#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <map>

#include "filter_scenario.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/configuration/simulator_config.h"
#include "mrpt_ext/configuration/simulator_keys.h"
#include "mrpt_ext/diagnosis/adopted_findings.h"
#include "mrpt_ext/diagnosis/log_diagnosis.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "mrpt_ext/settings/settings.h"
#include "mrpt_ext/simulation/random_errors.h"
#include "simulated_recording.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWithin = 3;  // stated deviations
const std::string kScenarioName = "uncalibrated";

/// What the sensor of a log measures, in turn.
const std::vector<std::pair<std::string, std::vector<std::string>>> kSensors{
    {"ranges and bearings", {"Sensor_camera.kind=range_bearing"}},
    {"bearings", {"Sensor_camera.kind=bearings"}},
    {"ranges", {"Sensor_camera.kind=ranges"}},
    {"anonymous", {"Sensor_camera.kind=range_bearing", "Sensor_camera.identity=anonymous"}}};

std::filesystem::path shippedIni(const std::string& app)
{
  return std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "ini" / app / (kScenarioName + ".ini");
}

/// A simulated log with its errors, on disk as long as it is needed.
class UncalibratedLog
{
 public:
  explicit UncalibratedLog(std::uint64_t seed)
      : folder_(std::filesystem::temp_directory_path() / ("diagnose_logs_" + std::to_string(getpid())))
  {
    registerAllClasses();
    std::filesystem::create_directories(folder_);
    Settings simulator =
        Settings::load(shippedIni("landmark-simulator"), simulatorKeys(), kSensors[seed % kSensors.size()].second);
    simulator.set("Simulation", "random_seed", std::to_string(seed), "seed");
    scenario_ = withRandomErrors(readScenario(simulator));
    const Recording recording = testing::simulate(readScenario(simulator));
    writeRawlog(folder_ / "log.rawlog", recording);
    writeLandmarkCsv(folder_ / "map.csv", recording.map);
    for (const Record& record : recording.records)
      if (const auto* reading = std::get_if<Reading>(&record))
      {
        ++readings_;
        detections_ += static_cast<double>(reading->detections.size());
      }
  }
  ~UncalibratedLog()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  UncalibratedLog(const UncalibratedLog&) = delete;
  UncalibratedLog& operator=(const UncalibratedLog&) = delete;

  [[nodiscard]] LocalizationInput input() const
  {
    Settings settings = Settings::load(shippedIni("landmark-localization"), localizationKeys());
    settings.set("LocalizationExperiment", "rawlog_file", folder_ / "log.rawlog", "study");
    settings.set("LocalizationExperiment", "ground_truth_path_file", "", "study");
    settings.set("MetricMap_landmarkMap2D_00_creationOpts", "landmarks_file", folder_ / "map.csv", "study");
    return loadLocalization(settings, {});
  }

  /// The true value of every key that --diagnose reports.
  [[nodiscard]] std::map<std::string, double> truth(const MotionModel& stated) const
  {
    const OdometryNoise& odometry = scenario_.odometry;
    const SimulatedSensor& camera = scenario_.sensors.front();
    const double noise = odometry.std_xy_per_m / stated.std_xy_per_m;
    return {{"odometry_scale", 1 / (1 + odometry.scale_error)},
            {"odometry_rotation_scale", 1 / (1 + odometry.rotation_scale_error)},
            {"odometry_pivot_scale", 1},
            {"odometry_distance_per_deg_m", 0},
            {"odometry_turn_per_m_deg", radToDeg(odometry.veer)},
            {"odometry_turn_per_s_deg", -radToDeg(odometry.drift) / (1 + odometry.rotation_scale_error)},
            {"delay_s", camera.delay_s},
            {"lever_arm_x_m", camera.lever_arm.x()},
            {"lever_arm_y_m", camera.lever_arm.y()},
            {"bias_bearing_deg", radToDeg(camera.bias_bearing)},
            {"odometry_yaw_deg", radToDeg(camera.bias_bearing)},  // in place of it, where it is adopted
            {"bias_range_m", camera.bias_range},
            {"scale_range", camera.scale_range},
            {"landmark_bias_range_m", 0},  // root mean square over the landmarks, as the next two
            {"landmark_shift_x_m", 0},
            {"landmark_shift_y_m", 0},
            {"std_bearing_deg", radToDeg(camera.std_bearing)},
            {"std_range_m", camera.std_range},
            {"range_along_axis", 0},
            {"scale_bearing", 1},
            {"range_axis_deg", radToDeg(camera.bias_bearing)},  // straight ahead, as logged
            {"clutter_probability", camera.clutter_per_reading * readings_ / detections_},
            {"std_xy_per_m", noise * stated.std_xy_per_m},
            {"std_phi_deg_per_deg", noise * stated.std_phi_per_deg},
            {"std_phi_deg_per_m", noise * radToDeg(stated.std_phi_per_m)}};
  }

 private:
  std::filesystem::path folder_;
  Scenario scenario_;
  double readings_ = 0, detections_ = 0;
};

/// The lines of one key.
struct LineTally
{
  std::size_t lines = 0, told = 0, within = 0, set = 0, improved = 0, adopted = 0, adopted_improved = 0;
  double errors = 0, deviations = 0, misfits = 0;  // sums of squares
};

bool improves(const CalibrationFinding& finding, double truth)
{
  return std::abs(finding.estimate - truth) < std::abs(finding.configured - truth);
}

void addLine(const CalibrationFinding& finding, double truth, LineTally& tally)
{
  ++tally.lines;
  if (!finding.why_not_observable.empty()) return;
  const double error = finding.estimate - truth;
  ++tally.told;
  tally.within += std::abs(error) <= kWithin * finding.std ? 1 : 0;
  tally.errors += square(error);
  tally.deviations += square(finding.std);
  tally.misfits += error == 0 ? 0 : square(error / finding.std);  // a yes or no has no deviation
  if (!finding.differs) return;
  ++tally.set;
  tally.improved += improves(finding, truth) ? 1 : 0;
}

using Tallies = std::map<std::string, LineTally>;

/// False when the log tells nothing.
bool addLog(std::uint64_t seed, Tallies& tallies, std::ostream* lines)
{
  const UncalibratedLog log(seed);
  const LocalizationInput input = log.input();
  const std::map<std::string, double> truth = log.truth(input.config.filter.motion);
  const LogDiagnosis diagnosis = diagnoseLog(input);
  for (const CalibrationFinding& finding : diagnosis.findings)
  {
    const double true_value = truth.at(finding.line.key);
    addLine(finding, true_value, tallies[finding.line.key]);
    if (lines)
      *lines << seed << ' ' << finding.line.key << ' ' << true_value << ' ' << finding.estimate << ' ' << finding.std
             << ' ' << (finding.estimate - true_value) / finding.std << ' '
             << (finding.why_not_observable.empty() ? finding.differs ? "set" : "told" : "unobservable") << std::endl;
  }
  std::vector<CalibrationUnknown> unknowns;
  for (const ParameterEstimate& error : diagnosis.errors.errors) unknowns.push_back(error.unknown);
  const CalibrationChoice choice = chooseCalibration(diagnosis.data, unknowns, input.config);
  for (const CalibrationFinding& finding : adoptedFindings(choice, diagnosis.data, input.config))
  {
    if (!truth.contains(finding.line.key)) continue;  // how well places are stated
    LineTally& tally = tallies[finding.line.key];
    ++tally.adopted;
    tally.adopted_improved += improves(finding, truth.at(finding.line.key)) ? 1 : 0;
  }
  return !diagnosis.findings.empty();
}

void printTallies(std::ostream& out, const std::string& sensor, const Tallies& tallies)
{
  for (const auto& [key, tally] : tallies)
  {
    const auto share = [](std::size_t part, std::size_t whole)
    { return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, whole)); };
    const auto told = static_cast<double>(std::max<std::size_t>(1, tally.told));
    out << "| " << sensor << " | " << key << " | " << tally.lines << std::fixed << std::setprecision(3) << " | "
        << 1 - share(tally.told, tally.lines) << " | " << share(tally.within, tally.told) << std::setprecision(4)
        << " | " << std::sqrt(tally.errors / told) << " | " << std::sqrt(tally.deviations / told)
        << std::setprecision(2) << " | " << std::sqrt(tally.misfits / told) << " | " << tally.improved << " of "
        << tally.set << " | " << tally.adopted_improved << " of " << tally.adopted << " |\n";
  }
}

void addTallies(const Tallies& more, Tallies& sum)
{
  for (const auto& [key, tally] : more)
  {
    LineTally& to = sum[key];
    to.lines += tally.lines;
    to.told += tally.told;
    to.within += tally.within;
    to.set += tally.set;
    to.improved += tally.improved;
    to.adopted += tally.adopted;
    to.adopted_improved += tally.adopted_improved;
    to.errors += tally.errors;
    to.deviations += tally.deviations;
    to.misfits += tally.misfits;
  }
}

void runDiagnoseLogs(std::ostream& out)
{
  const int runs = studyRuns(200);
  const bool every_line = std::getenv("STUDY_LINES") != nullptr;
  std::vector<Tallies> by_sensor(kSensors.size());
  std::size_t without = 0;
  for (int k = 0; k < runs; ++k)
  {
    const std::uint64_t seed = studySeed(k);
    without += addLog(seed, by_sensor[seed % kSensors.size()], every_line ? &out : nullptr) ? 0 : 1;
  }
  out << "Logs: " << runs << ", without findings: " << without
      << ".\n\n| sensor | key | lines | said to be unobservable | within " << kWithin
      << " stated deviations | scatter | stated | RMS error in stated deviations | set lines that improve | adopted "
         "lines that improve |\n|---|---|---|---|---|---|---|---|---|---|\n";
  Tallies all;
  for (std::size_t s = 0; s < kSensors.size(); ++s)
  {
    printTallies(out, kSensors[s].first, by_sensor[s]);
    addTallies(by_sensor[s], all);
  }
  printTallies(out, "all", all);
}

const RegisterStudy kDiagnoseLogsStudy("diagnose_logs",
                                       "Logs with random errors: does every line of --diagnose agree with the truth?",
                                       runDiagnoseLogs);
}  // namespace
}  // namespace mrpt_ext
