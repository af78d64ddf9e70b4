#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace mrpt::serialization
{
class CArchive;
}  // namespace mrpt::serialization

namespace mrpt_ext
{
struct ObjectHeader;

/// Comments of a log (CObservationComment). MRPT writes version 1 since 2.11.12, which stock tools before it cannot
/// read. Here both versions are read and 0 is written, whatever MRPT is installed.
inline constexpr const char* kCommentClass = "mrpt::obs::CObservationComment";
inline constexpr int kLatestCommentVersion = 1;

/// `time` [s]
void writeComment(mrpt::serialization::CArchive& out, const std::string& text, double time);

/// The text of the comment that begins with this header. Throws where its end is missing.
[[nodiscard]] std::string readComment(mrpt::serialization::CArchive& in, const ObjectHeader& header);

/// What our logs state of themselves, a line each: "entries=N", and "warning=..." unless the warning is empty.
[[nodiscard]] std::string commentOf(std::size_t entries, const std::string& warning);
/// The number of entries that a comment states.
[[nodiscard]] std::optional<std::size_t> statedEntries(const std::string& comment);
/// The warning in a comment; empty without.
[[nodiscard]] std::string statedWarning(const std::string& comment);
}  // namespace mrpt_ext
