#include "mrpt_ext/report/finished_runs.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/report/summary_reader.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json readSummary(const fs::path& folder)
{
  const fs::path path = folder / "summary.json";
  std::ifstream file(path);
  if (!file) throw dataError(folder.string() + ": no summary.json, expected the output folder of a finished run");
  try
  {
    Json summary = Json::parse(file);
    if (summary.at("schema") != 1) throw dataError(path.string() + ": unknown schema, expected 1");
    return summary;
  }
  catch (const Json::exception& error)
  {
    throw dataError(path.string() + ": " + error.what());
  }
}

FinishedTrial trialOf(const Json& summary)
{
  const RunScore score = runScoreOf(summary);
  FinishedTrial trial;
  trial.score = score.trials.front();
  for (const MethodScore& method : score.methods)
  {
    trial.position_rmse_m[method.name] = method.position_error_m.rmse;
    trial.position_median_m[method.name] = method.position_error_m.median;
    trial.position_p95_m[method.name] = method.position_error_m.p95;
    trial.heading_rmse_deg[method.name] = method.heading_error_deg.rmse;
  }
  trial.ok_share["particle_filter"] = score.verdict_shares.ok;
  trial.coverage_95["particle_filter"] = score.filter.coverage_95;
  return trial;
}

/// The trials below a folder in their order, or the folder itself.
std::vector<fs::path> trialFolders(const fs::path& folder)
{
  std::vector<fs::path> trials;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory() && entry.path().filename().string().starts_with("trial_") &&
        fs::exists(entry.path() / "summary.json"))
      trials.push_back(entry.path());
  std::sort(trials.begin(), trials.end());
  return trials.empty() ? std::vector<fs::path>{folder} : trials;
}

/// The resolved configuration without the keys that may differ between parts of one study; empty without the file.
std::string configurationText(const fs::path& folder)
{
  std::ifstream file(folder / "config_resolved.ini");
  std::string kept;
  for (std::string line; std::getline(file, line);)
    if (!line.starts_with("random_seed") && !line.starts_with("experimentRepetitions")) kept += line + "\n";
  return kept;
}

/// The same as a map from Section.key to value.
std::map<std::string, std::string> settingsOf(const std::string& configuration)
{
  std::map<std::string, std::string> settings;
  std::istringstream lines(configuration);
  std::string section;
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("[") && line.ends_with("]"))
      section = line.substr(1, line.size() - 2);
    else if (!line.starts_with(";") && equals != std::string::npos)
      settings[section + "." + line.substr(0, equals)] = line.substr(equals + 3);
  }
  return settings;
}

void addTrials(FinishedRun& run, const fs::path& folder)
{
  for (const fs::path& part : trialFolders(folder))
  {
    const FinishedTrial trial = trialOf(readSummary(part));
    const bool known =
        std::any_of(run.trials.begin(), run.trials.end(),
                    [&](const FinishedTrial& other)
                    { return other.score.trial == trial.score.trial && other.score.seed == trial.score.seed; });
    if (known)
      ++run.repeated;
    else
      run.trials.push_back(trial);
  }
}

/// "room", "room 2" ... where several runs have a configuration of this name.
std::string uniqueName(const std::string& name, const std::vector<FinishedRun>& runs)
{
  const auto taken = [&](const std::string& wanted)
  { return std::any_of(runs.begin(), runs.end(), [&](const FinishedRun& run) { return run.name == wanted; }); };
  std::string unique = name;
  for (int i = 2; taken(unique); ++i) unique = name + " " + std::to_string(i);
  return unique;
}

FinishedRun runOf(const Json& summary, const std::vector<FinishedRun>& runs)
{
  FinishedRun run;
  run.name = uniqueName(fs::path(summary.at("config").get<std::string>()).stem().string(), runs);
  run.rawlog_path = summary.at("rawlog").at("path");
  if (summary.at("rawlog").at("sha256").is_string()) run.rawlog_sha256 = summary.at("rawlog").at("sha256");
  run.version = summary.at("version");
  return run;
}
}  // namespace

std::vector<FinishedRun> readFinishedRuns(const std::vector<fs::path>& folders)
{
  std::vector<FinishedRun> runs;
  std::map<std::string, std::size_t> run_of;  // by log and configuration
  for (const fs::path& folder : folders)
  {
    const Json summary = readSummary(folder);
    try
    {
      const std::string configuration = configurationText(folder), key = summary.at("rawlog").dump() + configuration;
      const auto [place, is_new] = run_of.try_emplace(key, runs.size());
      if (is_new)
      {
        runs.push_back(runOf(summary, runs));
        runs.back().settings = settingsOf(configuration);
      }
      FinishedRun& run = runs[place->second];
      run.folders.push_back(folder.string());
      for (const auto& [name, method] : summary.at("methods").items())
        if (std::find(run.methods.begin(), run.methods.end(), name) == run.methods.end()) run.methods.push_back(name);
      addTrials(run, folder);
    }
    catch (const Json::exception& error)
    {
      throw dataError(folder.string() + ": incomplete summary.json: " + error.what());
    }
  }
  return runs;
}

std::vector<double> valuesOf(const FinishedRun& run, const std::string& method, NumberByMethod FinishedTrial::*number)
{
  std::vector<double> values;
  for (const FinishedTrial& trial : run.trials)
    if (const auto found = (trial.*number).find(method); found != (trial.*number).end() && found->second)
      values.push_back(*found->second);
  return values;
}

std::vector<double> convergenceTimes(const FinishedRun& run)
{
  std::vector<double> times;
  for (const FinishedTrial& trial : run.trials)
    if (trial.score.converged_at_s) times.push_back(*trial.score.converged_at_s);
  return times;
}
}  // namespace mrpt_ext
