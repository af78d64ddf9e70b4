#include "mrpt_ext/importers/rosbag2/sqlite_bag.h"

#include <sqlite3.h>

#include <map>
#include <memory>

#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr int kLargestValue = 1 << 28;  // [bytes] of a message or a text

/// Of a file that nobody writes: sqlite3 then needs no right to write beside it; unless there is a log to be read, too.
std::string uriOf(const std::filesystem::path& path)
{
  std::string uri = "file:";
  for (const char letter : path.string())
  {
    if (letter == '%' || letter == '?' || letter == '#')
      uri += formatted("%%%02x", static_cast<unsigned int>(letter));
    else
      uri += letter;
  }
  return std::filesystem::exists(path.string() + "-wal") ? uri : uri + "?immutable=1";
}

/// A database that is only read, and not trusted: its tables are read as they are stored, nothing in it is run.
class Database
{
 public:
  explicit Database(const std::filesystem::path& path)
  {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(uriOf(path).c_str(), &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    handle_.reset(opened);
    if (code != SQLITE_OK) fail();
    sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, kLargestValue);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  }

  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
  [[noreturn]] void fail() const
  {
    throw DamagedBytes(handle_ ? sqlite3_errmsg(handle_.get()) : "sqlite3 has no memory for it");
  }

 private:
  std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle_{nullptr, &sqlite3_close};
};

class Query
{
 public:
  Query(const Database& database, const std::string& text) : database_(database)
  {
    sqlite3_stmt* prepared = nullptr;
    const int code = sqlite3_prepare_v2(database.handle(), text.c_str(), -1, &prepared, nullptr);
    statement_.reset(prepared);
    if (code != SQLITE_OK) database_.fail();
  }

  /// Goes to the next row; false behind the last one.
  bool next()
  {
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail();
    return code == SQLITE_ROW;
  }
  [[nodiscard]] std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  [[nodiscard]] std::string_view bytes(int column) const
  {
    const auto* data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return data ? std::string_view(data, static_cast<std::size_t>(size)) : std::string_view();
  }
  [[nodiscard]] std::string text(int column) const { return std::string(bytes(column)); }

 private:
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> statement_{nullptr, &sqlite3_finalize};
};

/// Whether it has a table of rows on disk: a view or a virtual table would run what the file says.
bool hasTable(const Database& database, const std::string& name)
{
  Query tables(database, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND rootpage > 0 AND name = '" + name + "'");
  return tables.next();
}

std::map<std::string, std::string> definitionsIn(const Database& database)
{
  std::map<std::string, std::string> definitions;
  if (!hasTable(database, "message_definitions")) return definitions;
  Query rows(database,
             "SELECT topic_type, encoded_message_definition FROM message_definitions WHERE encoding = 'ros2msg'");
  while (rows.next()) definitions.emplace(rows.text(0), rows.text(1));
  return definitions;
}

std::map<std::int64_t, BagTopic> topicsIn(const Database& database)
{
  const auto definitions = definitionsIn(database);
  std::map<std::int64_t, BagTopic> topics;
  Query rows(database, "SELECT id, name, type, serialization_format FROM topics");
  while (rows.next())
  {
    BagTopic topic{rows.text(1), rows.text(2), rows.text(3), {}};
    if (const auto found = definitions.find(topic.type); found != definitions.end()) topic.definition = found->second;
    topics.emplace(rows.integer(0), std::move(topic));
  }
  return topics;
}

void readMessages(const Database& database, const BagMessageSink& sink)
{
  for (const char* table : {"topics", "messages"})
    if (!hasTable(database, table)) throw DamagedBytes(std::string("no table ") + table + ", expected a ROS 2 bag");
  const auto topics = topicsIn(database);
  Query rows(database, "SELECT topic_id, timestamp, data FROM messages");
  for (std::uint64_t number = 0; rows.next(); ++number)
  {
    const auto topic = topics.find(rows.integer(0));
    if (topic == topics.end())
      throw DamagedBytes("message " + std::to_string(number) + ": of topic " + std::to_string(rows.integer(0)) +
                         ", which is not in the table topics");
    sink({topic->second, static_cast<double>(rows.integer(1)) * 1e-9, number, rows.bytes(2)});
  }
}
}  // namespace

bool isSqlite(std::string_view start) { return start.starts_with(std::string_view("SQLite format 3\0", 16)); }

void readSqliteBag(const std::filesystem::path& path, const BagMessageSink& sink)
{
  try
  {
    readMessages(Database(path), sink);
  }
  catch (const DamagedBytes& damage)
  {
    throw dataError(path.string() + ": " + damage.what());
  }
}
}  // namespace mrpt_ext
