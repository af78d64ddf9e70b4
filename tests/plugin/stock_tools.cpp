#include "stock_tools.h"

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "mrpt_ext/maps/register_all_classes.h"

namespace mrpt_ext
{
void StockToolTest::SetUp()
{
  registerAllClasses();
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = std::filesystem::path(::testing::TempDir()) /
            (std::string(info->test_suite_name()) + "_" + info->name() + "_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder_);
}

void StockToolTest::TearDown() { std::filesystem::remove_all(folder_); }

std::string StockToolTest::run(const std::string& command) const
{
  const std::string line = "cd '" + folder_.string() + "' && timeout 120 sh -c \"" + command + "\" 2>&1 </dev/null";
  std::FILE* pipe = popen(line.c_str(), "r");
  if (!pipe) return "cannot run: " + line;
  std::string output;
  std::array<char, 4096> buffer{};
  for (std::size_t got = 0; (got = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.append(buffer.data(), got);
  pclose(pipe);
  return output;
}

bool isInstalled(const std::string& program)
{
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::filesystem::path pluginPath(const std::string& folder)
{
  return std::filesystem::path(MRPT_EXT_BINARY_DIR) / "lib" / ("libmrpt_ext_" + folder + ".so");
}

std::string preload(const std::string& folder)
{
  Dl_info runtime{};
  const void* sanitizer = dlsym(RTLD_DEFAULT, "__asan_init");
  const bool is_sanitized = sanitizer && dladdr(sanitizer, &runtime) != 0;
  return "LD_PRELOAD='" + (is_sanitized ? runtime.dli_fname + std::string(" ") : "") + pluginPath(folder).string() +
         "'";
}

std::string readText(const std::filesystem::path& path)
{
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}
}  // namespace mrpt_ext
