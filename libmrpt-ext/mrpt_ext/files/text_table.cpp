#include "mrpt_ext/files/text_table.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/trimmed.h"
#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/geometry/physical_limits.h"

namespace mrpt_ext
{
namespace
{
std::vector<std::string> splitAtCommas(std::string_view text)
{
  std::vector<std::string> fields;
  while (true)
  {
    const std::size_t comma = text.find(',');
    fields.emplace_back(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    text.remove_prefix(comma + 1);
  }
}

std::vector<std::string> splitAtBlanks(std::string_view text)
{
  std::vector<std::string> fields;
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(kBlanks, begin)) != std::string_view::npos)
  {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    fields.emplace_back(text.substr(begin, end - begin));
    begin = end;
  }
  return fields;
}

template <typename Names>
std::string commaSeparated(const Names& names)
{
  std::string text;
  for (const auto& name : names) (text += text.empty() ? "" : ",") += name;
  return text;
}

std::string_view withoutByteOrderMark(std::string_view text)
{
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}
}  // namespace

TextTable::TextTable(const std::filesystem::path& path, TextTableFormat format)
    : path_(path), format_(std::move(format))
{
  read([] {});
}

void TextTable::read(const std::function<void()>& row_added)
{
  int line = 0;
  const auto take = [&](std::string_view text)
  {
    const std::size_t before = rows_.size();
    if (++line == 1) text = withoutByteOrderMark(text);
    addLine(text, line);
    if (rows_.size() > before) row_added();
  };
  forEachLine(path_, take);
  if (format_.columns.empty()) throw errorAtLine(1, "the file is empty, expected a header line with column names");
}

void forEachRow(const std::filesystem::path& path, TextTableFormat format,
                const std::function<void(const TextTable&)>& take)
{
  TextTable table;
  table.path_ = path;
  table.format_ = std::move(format);
  const auto take_row = [&]
  {
    take(table);
    table.rows_.clear();
  };
  table.read(take_row);
}

void TextTable::addLine(std::string_view line_text, int line)
{
  line_text = trimmed(line_text);
  if (line_text.empty()) return;
  if (!format_.comment_prefix.empty() && line_text.starts_with(format_.comment_prefix)) return;
  auto fields = format_.delimiter == Delimiter::comma ? splitAtCommas(line_text) : splitAtBlanks(line_text);
  if (format_.columns.empty())
  {
    header_line_ = line;
    if (format_.delimiter == Delimiter::comma && fields.size() == 1 && line_text.find(';') != std::string_view::npos)
      throw errorAtLine(line,
                        "fields are separated by semicolons, expected commas, and points in numbers: sed "
                        "'s/,/./g; s/;/,/g' converts the file");
    format_.columns = std::move(fields);
    for (std::size_t i = 0; i < columns().size(); ++i)
      if (findColumn(columns()[i]) != i) throw errorAtLine(line, "column '" + columns()[i] + "' occurs twice");
    return;
  }
  if (!isWanted(fields.front(), line)) return;
  if (fields.size() != columns().size())
    throw errorAtLine(line, std::to_string(fields.size()) + " fields, expected " + std::to_string(columns().size()) +
                                " (" + commaSeparated(columns()) + ")");
  if (++count_ > format_.limit.rows)
    throw errorAtLine(line, "more than " + std::to_string(format_.limit.rows) + " rows, expected no more" +
                                (format_.limit.set_by.empty() ? "" : ": set " + format_.limit.set_by));
  rows_.push_back({line, std::move(fields)});
}

bool TextTable::isWanted(const std::string& type, int line) const
{
  const auto& [read, others] = format_.types;
  if (read.empty() || type == read) return true;
  if (std::find(others.begin(), others.end(), type) != others.end()) return false;
  throw errorAtLine(line, "unknown type of row '" + type + "', expected " + read +
                              (others.empty() ? "" : " or " + commaSeparated(others)));
}

std::optional<std::size_t> TextTable::findColumn(std::string_view name) const
{
  const auto found = std::find(columns().begin(), columns().end(), name);
  if (found == columns().end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns().begin());
}

std::size_t TextTable::column(std::string_view name) const
{
  if (const auto found = findColumn(name)) return *found;
  throw errorAtLine(header_line_,
                    "no column '" + std::string(name) + "', the header line has " + commaSeparated(columns()));
}

const std::string& TextTable::text(std::size_t row, std::size_t column) const
{
  return rows_.at(row).fields.at(column);
}

double TextTable::numberWithin(std::size_t row, std::size_t column, double limit) const
{
  const auto value = parseNumber(text(row, column));
  if (!value) throw wrongField(row, column, "a number");
  if (std::abs(*value) > limit) throw wrongField(row, column, formatted("within %g either way", limit));
  return *value;
}

double TextTable::number(std::size_t row, std::size_t column) const { return numberWithin(row, column, kLargestTime); }

double TextTable::coordinate(std::size_t row, std::size_t column) const
{
  return numberWithin(row, column, kLargestCoordinate);
}

std::optional<double> TextTable::optionalNumber(std::size_t row, std::size_t column) const
{
  if (text(row, column).empty()) return std::nullopt;
  return number(row, column);
}

int TextTable::integer(std::size_t row, std::size_t column) const
{
  if (const auto value = parseInteger(text(row, column))) return *value;
  throw wrongField(row, column, "an integer");
}

InputError TextTable::errorAt(std::size_t row, const std::string& message) const
{
  return errorAtLine(rows_.at(row).line, message);
}

void TextTable::expectOnlyColumns(const std::vector<std::string_view>& known) const
{
  for (const std::string& name : columns())
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw errorAtLine(header_line_, "unknown column '" + name + "', expected only " + commaSeparated(known));
}

InputError TextTable::errorAtLine(int line, const std::string& message) const
{
  return dataError(path_.string() + ":" + std::to_string(line) + ": " + message);
}

InputError TextTable::wrongField(std::size_t row, std::size_t column, std::string_view expected) const
{
  return errorAt(row,
                 "'" + text(row, column) + "' is not " + std::string(expected) + ", expected " + columns()[column]);
}
}  // namespace mrpt_ext
