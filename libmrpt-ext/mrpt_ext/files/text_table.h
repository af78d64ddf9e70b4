#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
enum class Delimiter
{
  comma,       ///< every comma separates; fields are trimmed and may be empty
  white_space  ///< runs of blanks and tabs separate
};

/// Which rows to read from a file whose rows begin with their type.
struct RowTypes
{
  std::string read;                 ///< type of the rows to read; empty: all rows
  std::vector<std::string> others;  ///< types that are skipped; any other type is an error
};

/// How many rows are read at most, and the key or option that sets it, for the error about one more.
struct RowLimit
{
  std::size_t rows = 50'000'000;
  std::string set_by = {};
};

/// How a table file is laid out.
struct TextTableFormat
{
  Delimiter delimiter = Delimiter::comma;
  std::string comment_prefix = "#";  ///< lines that begin with it are skipped; empty: no comments
  std::vector<std::string> columns;  ///< names, in file order; empty: the first row is a header that names them
  RowTypes types = {};
  RowLimit limit = {};
};

/// A delimited text file in memory. Every row has one field per column: a row of another length is an error, so that a
/// cut-off line is never taken for data. Errors are InputError (data), `file:line: what is wrong, what is expected`.
class TextTable
{
 public:
  /// Reads a file, plain or gzip. Empty lines and comments are skipped, line ends may be LF or CRLF.
  TextTable(const std::filesystem::path& path, TextTableFormat format);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] const std::vector<std::string>& columns() const { return format_.columns; }
  [[nodiscard]] std::optional<std::size_t> findColumn(std::string_view name) const;
  /// Column of that name, or an error on the header line.
  [[nodiscard]] std::size_t column(std::string_view name) const;

  [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const;
  /// A number, or an error; finite, and not beyond the largest time: no unit of a table needs larger ones.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
  /// Nothing for an empty field.
  [[nodiscard]] std::optional<double> optionalNumber(std::size_t row, std::size_t column) const;
  /// A number within what a coordinate or a distance in metres can be (geometry/physical_limits.h), or an error.
  [[nodiscard]] double coordinate(std::size_t row, std::size_t column) const;
  [[nodiscard]] int integer(std::size_t row, std::size_t column) const;

  /// `file:line: <message>` for this row, to be thrown by readers that check the meaning of a value.
  [[nodiscard]] InputError errorAt(std::size_t row, const std::string& message) const;
  /// Throws an error on the header line when a column is not among `known`: a misspelt one must not be lost silently.
  void expectOnlyColumns(const std::vector<std::string_view>& known) const;

 private:
  struct Row
  {
    int line = 0;
    std::vector<std::string> fields;
  };
  TextTable() = default;
  friend void forEachRow(const std::filesystem::path& path, TextTableFormat format,
                         const std::function<void(const TextTable&)>& take);
  void read(const std::function<void()>& row_added);
  void addLine(std::string_view line_text, int line);
  /// False for rows of a type that is skipped.
  [[nodiscard]] bool isWanted(const std::string& type, int line) const;
  [[nodiscard]] InputError errorAtLine(int line, const std::string& message) const;
  [[nodiscard]] double numberWithin(std::size_t row, std::size_t column, double limit) const;
  [[nodiscard]] InputError wrongField(std::size_t row, std::size_t column, std::string_view expected) const;

  std::filesystem::path path_;
  TextTableFormat format_;
  int header_line_ = 1;
  std::size_t count_ = 0;  // of rows, also of those that are not kept
  std::vector<Row> rows_;
};

/// Reads such a file without keeping it: `take` is given every row as a table of that row alone.
void forEachRow(const std::filesystem::path& path, TextTableFormat format,
                const std::function<void(const TextTable&)>& take);
}  // namespace mrpt_ext
