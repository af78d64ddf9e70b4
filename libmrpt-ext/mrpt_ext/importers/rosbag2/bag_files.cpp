#include "mrpt_ext/importers/rosbag2/bag_files.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>

#include "mrpt_ext/files/decompressor.h"
#include "mrpt_ext/files/staged_file.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/rosbag2/block_decompression.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"
#include "mrpt_ext/importers/rosbag2/mcap_reader.h"
#include "mrpt_ext/importers/rosbag2/sqlite_bag.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

/// The files of a recording, in order.
struct BagFiles
{
  std::vector<fs::path> paths;
  bool packed_messages = false;  ///< each message is zstd data
};

std::string startOf(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw dataError(path.string() + ": cannot be opened");
  std::string bytes(16, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool isZstd(std::string_view start)
{
  return compressionOf({reinterpret_cast<const unsigned char*>(start.data()), start.size()}) == Compression::zstd;
}

/// All bag files of a folder without metadata, by name.
BagFiles filesWithoutMetadata(const fs::path& folder)
{
  BagFiles files;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    fs::path name = entry.path().filename();
    if (name.extension() == ".zstd") name = name.stem();
    if (name.extension() == ".mcap" || name.extension() == ".db3") files.paths.push_back(entry.path());
  }
  std::sort(files.paths.begin(), files.paths.end());
  if (files.paths.empty())
    throw dataError(folder.string() + ": neither metadata.yaml nor a file .mcap or .db3 in this folder");
  return files;
}

BagFiles filesIn(const fs::path& folder)
{
  const fs::path metadata = folder / "metadata.yaml";
  if (!fs::exists(metadata)) return filesWithoutMetadata(folder);
  BagFiles files;
  try
  {
    const YAML::Node bag = YAML::Load(readTextFile(metadata))["rosbag2_bagfile_information"];
    for (const YAML::Node& name : bag["relative_file_paths"]) files.paths.push_back(folder / name.as<std::string>());
    const YAML::Node mode = bag["compression_mode"];
    if (mode && mode.IsScalar()) files.packed_messages = mode.Scalar() == "message" || mode.Scalar() == "MESSAGE";
  }
  catch (const YAML::Exception& error)
  {
    throw dataError(metadata.string() + ": " + error.what());
  }
  if (files.paths.empty()) throw dataError(metadata.string() + ": names no files, expected relative_file_paths");
  // Of a recording that was cut off, or before it is compressed, the name in the metadata may be the other one.
  for (fs::path& path : files.paths)
    if (!fs::exists(path))
    {
      const fs::path other =
          path.extension() == ".zstd" ? fs::path(path).replace_extension() : fs::path(path.string() + ".zstd");
      if (fs::exists(other)) path = other;
    }
  return files;
}

/// Unpacks messages, and adds to the damage of a message which one it was.
class MessageHandling
{
 public:
  MessageHandling(const fs::path& path, bool packed, const BagMessageSink& sink)
      : path_(path), packed_(packed), sink_(sink)
  {
  }
  void operator()(const BagMessage& message) const
  {
    try
    {
      if (!packed_) return sink_(message);
      const std::string unpacked = decompressedBlock(message.data, "zstd", kLargestMessage);
      sink_({message.topic, message.time, message.number, unpacked});
    }
    catch (const DamagedBytes& damage)
    {
      throw dataError(path_.string() + ": message " + std::to_string(message.number) + " (" + message.topic.name +
                      "): " + damage.what());
    }
  }

 private:
  static constexpr std::uint64_t kLargestMessage = 1 << 28;  // [bytes]
  const fs::path& path_;
  bool packed_;
  const BagMessageSink& sink_;
};

std::vector<std::string> readFile(const fs::path& path, const BagMessageSink& sink)
{
  const std::string start = startOf(path);
  if (isMcap(start)) return readMcap(path, sink);
  if (!isSqlite(start))
    throw dataError(path.string() + ": neither an MCAP nor an sqlite3 file" +
                    (start.starts_with("#ROSBAG") ? ", but a bag of ROS 1, expected one of ROS 2" : ""));
  readSqliteBag(path, sink);
  return {};
}

/// Reads the content of a zstd file; what is said about it names the file that the user knows.
std::vector<std::string> readPackedFile(const fs::path& path, const BagMessageSink& sink)
{
  const StagedFile file(fs::temp_directory_path() / "mrpt_ext_bag");  // removed also when a signal ends the program
  const fs::path& unpacked = file.path();
  decompressZstdFile(path, unpacked);
  const auto renamed = [&](std::string text)
  {
    const std::string name = unpacked.string();
    if (text.starts_with(name)) text.replace(0, name.size(), path.string());
    return text;
  };
  try
  {
    std::vector<std::string> notes = readFile(unpacked, sink);
    for (std::string& note : notes) note = renamed(note);
    return notes;
  }
  catch (const InputError& error)
  {
    throw InputError(error.kind(), renamed(error.what()));
  }
}
}  // namespace

std::vector<std::string> readBag(const std::vector<fs::path>& inputs, const BagMessageSink& sink)
{
  const BagFiles files = inputs.size() == 1 && fs::is_directory(inputs[0]) ? filesIn(inputs[0]) : BagFiles{inputs};
  std::vector<std::string> notes;
  for (const fs::path& path : files.paths)
  {
    const MessageHandling handle(path, files.packed_messages, sink);
    for (const std::string& note : isZstd(startOf(path)) ? readPackedFile(path, handle) : readFile(path, handle))
      notes.push_back(note);
  }
  return notes;
}
}  // namespace mrpt_ext
