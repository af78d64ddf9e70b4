#pragma once

#include <gtest/gtest.h>
#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/rawlog/rawlog_source.h"

namespace mrpt_ext
{
/// A folder of its own for each test, removed afterwards.
class RawlogTest : public ::testing::Test
{
 protected:
  void SetUp() override;
  void TearDown() override;
  [[nodiscard]] std::filesystem::path inFolder(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

/// `seconds` of odometry at 10 Hz with bearings, ranges, compass and running fixes at 1 Hz.
[[nodiscard]] Recording sampleRecording(int seconds);

/// Writes any objects as a log, gzip-compressed.
void writeObjects(const std::filesystem::path& path,
                  const std::vector<mrpt::serialization::CSerializable::Ptr>& objects);

[[nodiscard]] std::string readBytes(const std::filesystem::path& path);
void writeBytes(const std::filesystem::path& path, const std::string& bytes);
[[nodiscard]] std::string decompress(const std::string& gzip);
[[nodiscard]] std::string compress(const std::string& content);

/// Records until the end or the first error, and the error's message (empty: none).
struct ReadResult
{
  std::vector<Record> records;
  std::string error;
  RawlogStatistics statistics;
};
[[nodiscard]] ReadResult readLog(const std::filesystem::path& path);
}  // namespace mrpt_ext
