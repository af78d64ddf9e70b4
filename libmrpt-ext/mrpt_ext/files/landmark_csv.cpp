#include "mrpt_ext/files/landmark_csv.h"

#include <algorithm>
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
  table.expectOnlyColumns({"id", "x", "y", "z", "category", "std_x", "std_y"});
  const std::size_t x = table.column("x"), y = table.column("y");
  const auto id = table.findColumn("id"), z = table.findColumn("z"), category = table.findColumn("category");
  const auto std_x = table.findColumn("std_x"), std_y = table.findColumn("std_y");

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
    landmarks.push_back(std::move(landmark));
  }
  return LandmarkTable(std::move(landmarks));
}

void writeLandmarkCsv(const std::filesystem::path& path, const LandmarkTable& landmarks)
{
  const bool with_std = std::any_of(landmarks.all().begin(), landmarks.all().end(),
                                    [](const Landmark& landmark) { return !landmark.stddev.isZero(0); });
  std::string content = with_std ? "id,x,y,z,category,std_x,std_y\n" : "id,x,y,z,category\n";
  for (const Landmark& landmark : landmarks.all())
  {
    if (landmark.id != kNoId) content += std::to_string(landmark.id);
    for (const double coordinate : landmark.position) content += ',' + shortestText(coordinate);
    content += ',' + categoryText(landmark);
    if (with_std) content += ',' + shortestText(landmark.stddev.x()) + ',' + shortestText(landmark.stddev.y());
    content += '\n';
  }
  writeFileAtomically(path, content);
}
}  // namespace mrpt_ext
