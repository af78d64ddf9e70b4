#include "mrpt_ext/rawlog/unreadable_class.h"

#include <array>
#include <regex>

namespace mrpt_ext
{
namespace
{
struct Release
{
  const char* class_name;
  int version;
  const char* mrpt;
};
/// Since which MRPT a class is written in this version.
constexpr std::array kReleases = {
    Release{"CObservationComment", 1, "2.11.12"},    Release{"CObservationRange", 4, "2.11.2"},
    Release{"CObservationGPS", 12, "2.11.12"},       Release{"CObservationGPS", 13, "2.15.11"},
    Release{"CObservation2DRangeScan", 8, "2.15.6"}, Release{"CImage", 10, "3.0"}};

std::string writtenBy(const std::string& class_name, int version)
{
  const std::string name = withoutNamespace(class_name);
  for (const Release& release : kReleases)
    if (name == release.class_name && version == release.version)
      return "written by MRPT " + std::string(release.mrpt) + " or newer";
  return "written by a newer MRPT";
}

std::optional<std::string> lastMatch(const std::string& text, const std::regex& pattern)
{
  std::optional<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) found = (*match)[1];
  return found;
}
}  // namespace

std::optional<UnreadableClass> unreadableClass(const ObjectHeader& header, const std::string& exception)
{
  static const std::regex kUnknown("class '([^']*)' which is not registered");
  static const std::regex kVersion("unknown serialization version number: '([0-9]+)'");
  static const std::regex kObject("parsing typed object '([^']*)'");
  if (const auto name = lastMatch(exception, kUnknown)) return UnreadableClass{*name, std::nullopt};
  const auto version = lastMatch(exception, kVersion);
  if (!version) return std::nullopt;
  // The innermost object: an image within an observation.
  return UnreadableClass{lastMatch(exception, kObject).value_or(header.class_name), std::stoi(*version)};
}

std::string UnreadableClass::reason() const
{
  if (!version) return "unknown class";
  return "version " + std::to_string(*version) + ", " + writtenBy(class_name, *version);
}

std::string UnreadableClass::explanation() const
{
  if (!version)
    return "unknown class '" + class_name +
           "', expected a class of MRPT or of a loaded plugin: run with LD_PRELOAD=<library that defines it>.so";
  return writtenBy(class_name, *version) + ": " + withoutNamespace(class_name) + " version " +
         std::to_string(*version) +
         "; the MRPT that this program is built with cannot read it, build it with that MRPT";
}
}  // namespace mrpt_ext
