#include "mrpt_ext/importers/roh.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/importers/recording_notes.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

/// One file of readings and where they were taken.
struct Standstill
{
  Vector2d position;
  fs::path path;
};

// Position from a file name such as "(X1.5,Y4.5).csv"; nothing for other names.
std::optional<Vector2d> positionInName(const std::string& name)
{
  static const std::regex kName(R"(\(X([-+.0-9]+),Y([-+.0-9]+)\)\.csv)");
  std::smatch match;
  if (!std::regex_match(name, match, kName)) return std::nullopt;
  const auto x = parseNumber(match[1].str()), y = parseNumber(match[2].str());
  if (!x || !y) return std::nullopt;
  return Vector2d(*x, *y);
}

std::vector<Standstill> findStandstills(const fs::path& folder)
{
  if (!fs::is_directory(folder)) throw dataError(folder.string() + ": no such folder, expected (Xx,Yy).csv files");
  std::vector<Standstill> standstills;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const auto position = positionInName(entry.path().filename().string()))
      standstills.push_back({*position, entry.path()});
  if (standstills.empty()) throw dataError(folder.string() + ": no file named like (X1.5,Y4.5).csv");
  std::sort(standstills.begin(), standstills.end(),
            [](const Standstill& a, const Standstill& b)
            { return std::pair(a.position.x(), a.position.y()) < std::pair(b.position.x(), b.position.y()); });
  return standstills;
}

LandmarkTable readLandmarks(const fs::path& path)
{
  const TextTable table(path, {Delimiter::comma, "#", {"x", "y"}});
  std::vector<Landmark> landmarks;
  for (std::size_t row = 0; row < table.size(); ++row)
    landmarks.push_back(
        {static_cast<int>(row) + 1, {table.number(row, 0), table.number(row, 1), 0}, kRohCategory, {0, 0}});
  return LandmarkTable(std::move(landmarks));
}

Reading readRow(const TextTable& table, std::size_t row, double time)
{
  Reading reading;
  reading.time = time;
  reading.sensor = kRohSensor;
  for (std::size_t i = 0; i < table.columns().size(); ++i)
  {
    const double degrees = table.number(row, i);
    if (std::abs(degrees) > 360)
      throw table.errorAt(row, "bearing " + table.text(row, i) + ", expected degrees within +-360");
    reading.detections.push_back(
        {static_cast<int>(i) + 1, kRohCategory, wrap(degToRad(degrees)), std::nullopt, kRohStdBearing, 0});
  }
  return reading;
}
}  // namespace

Recording importRoh(const fs::path& folder)
{
  const std::vector<Standstill> standstills = findStandstills(folder);
  Recording recording;
  recording.map = readLandmarks(folder / "landmark.csv");
  std::vector<std::string> columns;
  for (const Landmark& landmark : recording.map.all()) columns.push_back("bearing_" + std::to_string(landmark.id));
  for (const Standstill& standstill : standstills)
  {
    const TextTable table(standstill.path, {Delimiter::comma, "#", columns});
    for (std::size_t row = 0; row < table.size(); ++row)
    {
      const double time = static_cast<double>(recording.records.size() + 1);
      recording.records.emplace_back(readRow(table, row, time));
      recording.truth.push_back({time, {standstill.position.x(), standstill.position.y(), 0}, false});
    }
  }
  noteCount(recording, standstills.size(), "positions");
  recording.notes.emplace_back("independent frames: one per row, stamped one second apart");
  recording.notes.emplace_back("truth has no heading: it was set loosely when the readings were taken");
  return recording;
}
}  // namespace mrpt_ext
