#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace mrpt_ext
{
/// Runs MRPT's own programs with our plugins in a folder of its own for each test. Their exit codes mean little (0 also
/// when nothing could be read): look at what they print and write.
class StockToolTest : public ::testing::Test
{
 protected:
  void SetUp() override;
  void TearDown() override;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Runs a shell command in the folder, no longer than two minutes; both output streams.
  [[nodiscard]] std::string run(const std::string& command) const;

 private:
  std::filesystem::path folder_;
};

[[nodiscard]] bool isInstalled(const std::string& program);

/// The plugin of a folder of the tree, e.g. "observations".
[[nodiscard]] std::filesystem::path pluginPath(const std::string& folder);

/// LD_PRELOAD=... for a program that is to know the plugin's classes. The runtime of the address sanitizer, where this
/// build has one, has to be first.
[[nodiscard]] std::string preload(const std::string& folder);

[[nodiscard]] std::string readText(const std::filesystem::path& path);
[[nodiscard]] inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}  // namespace mrpt_ext
