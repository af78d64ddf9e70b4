#include "mrpt_ext/rawlog/rawlog_comment.h"

#include <mrpt/serialization/CArchive.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/object_header.h"

namespace mrpt_ext
{
namespace
{
/// A text of any length, piece by piece: a damaged length meets the end of the log before it fills the memory.
std::string readLongText(mrpt::serialization::CArchive& in)
{
  constexpr std::size_t kPiece = 1 << 16;
  std::string text;
  for (std::size_t left = in.ReadAs<std::uint32_t>(); left > 0;)
  {
    const std::size_t piece = std::min(left, kPiece);
    text.resize(text.size() + piece);
    in.ReadBuffer(text.data() + text.size() - piece, piece);
    left -= piece;
  }
  return text;
}

const std::string kEntries = "entries=", kWarning = "warning=";

/// What the first line that begins so ends with; empty without.
std::string stated(const std::string& comment, const std::string& beginning)
{
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(beginning, 0) == 0) return line.substr(beginning.size());
  return "";
}
}  // namespace

void writeComment(mrpt::serialization::CArchive& out, const std::string& text, double time)
{
  const std::string name = kCommentClass;
  out << static_cast<std::uint8_t>(0x80 | name.size());
  out.WriteBuffer(name.data(), name.size());
  out << std::uint8_t{0} << text << timestampOf(time) << std::uint8_t{kObjectEnd};
}

std::string readComment(mrpt::serialization::CArchive& in, const ObjectHeader& header)
{
  std::vector<char> read_already(header.size());
  in.ReadBuffer(read_already.data(), read_already.size());
  std::string text = readLongText(in);
  mrpt::system::TTimeStamp time;
  in >> time;
  if (header.version >= 1) static_cast<void>(readLongText(in));  // the label
  if (in.ReadAs<std::uint8_t>() != kObjectEnd) throw std::runtime_error("the end of the comment is missing");
  return text;
}

std::string commentOf(std::size_t entries, const std::string& warning)
{
  const std::string text = kEntries + std::to_string(entries);
  return warning.empty() ? text : text + '\n' + kWarning + warning;
}

std::optional<std::size_t> statedEntries(const std::string& comment)
{
  std::size_t number = 0;
  if (std::istringstream(stated(comment, kEntries)) >> number) return number;
  return std::nullopt;
}

std::string statedWarning(const std::string& comment) { return stated(comment, kWarning); }
}  // namespace mrpt_ext
