#include "mrpt_ext/files/landmark_csv.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_table.h"

namespace mrpt_ext
{
namespace
{
int readId(const TextTable& table, std::size_t row, std::optional<std::size_t> column)
{
  if (!column || table.text(row, *column).empty()) return kNoId;
  const int id = table.integer(row, *column);
  if (id < 0)
    throw table.errorAt(row, "landmark id " + std::to_string(id) + " is negative, expected >= 0 or empty (anonymous)");
  return id;
}

double readStd(const TextTable& table, std::size_t row, std::optional<std::size_t> column)
{
  if (!column || table.text(row, *column).empty()) return 0;
  const double value = table.coordinate(row, *column);
  if (value < 0) throw table.errorAt(row, table.columns()[*column] + " is negative, expected >= 0");
  return value;
}

/// [rad]; nothing where the field is empty.
std::optional<double> readYaw(const TextTable& table, std::size_t row, std::optional<std::size_t> column)
{
  if (!column || table.text(row, *column).empty()) return std::nullopt;
  const double degrees = table.number(row, *column);
  if (std::abs(degrees) > 360) throw table.errorAt(row, "yaw_deg is out of range, expected within +-360");
  return wrap(degToRad(degrees));
}

/// Angles in degrees, without the digits that their conversion has made.
std::string degreesText(double angle) { return shortestText(std::round(radToDeg(angle) * 1e9) / 1e9); }

/// ",yaw_deg", with a standard deviation ",yaw_deg,std_yaw_deg"; an unknown direction leaves both empty.
std::string yawText(const Landmark& landmark, bool with_std)
{
  if (!landmark.yaw) return with_std ? ",," : ",";
  return ',' + degreesText(*landmark.yaw) + (with_std ? ',' + degreesText(landmark.std_yaw) : "");
}

/// True for some landmark of the map.
bool hasAny(const LandmarkTable& landmarks, bool (*is)(const Landmark&))
{
  return std::any_of(landmarks.all().begin(), landmarks.all().end(), is);
}

std::string categoryText(const Landmark& landmark)
{
  if (landmark.category.find_first_of(",\r\n") != std::string::npos)
    throw dataError("landmark category '" + landmark.category + "' cannot be written, expected no comma or line end");
  return landmark.category;
}
}  // namespace

LandmarkTable readLandmarkCsv(const std::filesystem::path& path, const RowLimit& limit)
{
  const TextTable table(path, {.limit = limit});
  table.expectOnlyColumns({"id", "x", "y", "z", "category", "std_x", "std_y", "yaw_deg", "std_yaw_deg"});
  const std::size_t x = table.column("x"), y = table.column("y");
  const auto id = table.findColumn("id"), z = table.findColumn("z"), category = table.findColumn("category");
  const auto std_x = table.findColumn("std_x"), std_y = table.findColumn("std_y");
  const auto yaw = table.findColumn("yaw_deg"), std_yaw = table.findColumn("std_yaw_deg");

  std::vector<Landmark> landmarks;
  std::set<int> seen;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    Landmark landmark;
    landmark.id = readId(table, row, id);
    if (landmark.id != kNoId && !seen.insert(landmark.id).second)
      throw table.errorAt(row, "landmark id " + std::to_string(landmark.id) + " occurs twice, ids must be unique");
    const bool has_height = z && !table.text(row, *z).empty();
    landmark.position = {table.coordinate(row, x), table.coordinate(row, y),
                         has_height ? table.coordinate(row, *z) : 0};
    if (category) landmark.category = table.text(row, *category);
    landmark.stddev = {readStd(table, row, std_x), readStd(table, row, std_y)};
    landmark.yaw = readYaw(table, row, yaw);
    landmark.std_yaw = degToRad(readStd(table, row, std_yaw));
    landmarks.push_back(std::move(landmark));
  }
  return LandmarkTable(std::move(landmarks));
}

void writeLandmarkCsv(const std::filesystem::path& path, const LandmarkTable& landmarks)
{
  const bool with_std = hasAny(landmarks, [](const Landmark& landmark) { return !landmark.stddev.isZero(0); });
  const bool with_yaw = hasAny(landmarks, [](const Landmark& landmark) { return landmark.yaw.has_value(); });
  const bool with_std_yaw =
      hasAny(landmarks, [](const Landmark& landmark) { return landmark.yaw && landmark.std_yaw != 0; });
  std::string content = with_std ? "id,x,y,z,category,std_x,std_y" : "id,x,y,z,category";
  content += with_yaw ? ",yaw_deg" : "";
  content += with_std_yaw ? ",std_yaw_deg\n" : "\n";
  for (const Landmark& landmark : landmarks.all())
  {
    if (landmark.id != kNoId) content += std::to_string(landmark.id);
    for (const double coordinate : landmark.position) content += ',' + shortestText(coordinate);
    content += ',' + categoryText(landmark);
    if (with_std) content += ',' + shortestText(landmark.stddev.x()) + ',' + shortestText(landmark.stddev.y());
    if (with_yaw) content += yawText(landmark, with_std_yaw);
    content += '\n';
  }
  writeFileAtomically(path, content);
}
}  // namespace mrpt_ext
