#pragma once

#include <gtest/gtest.h>

#include "run_images.h"

namespace mrpt_ext::testing
{
inline const std::filesystem::path kOwnScene = std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "datasets/movis-field";

/// A scene gone through images2rawlog.
struct Measured
{
  LogFiles files;
  std::filesystem::path csv;
  AppOutcome outcome;
};

inline Measured measure(const std::filesystem::path& scene, const std::filesystem::path& folder,
                        const Arguments& more = {})
{
  Measured measured{logFiles(folder, "log"), folder / "log.csv", {}};
  measured.outcome = runImages(joined({shipped("images2rawlog", "movis").string(), "-i", scene.string(), "-o",
                                       measured.files.rawlog.string(), "--csv", measured.csv.string()},
                                      more));
  EXPECT_EQ(measured.outcome.exit_code, 0) << measured.outcome.err;
  EXPECT_EQ(measured.outcome.err, "");
  return measured;
}
}  // namespace mrpt_ext::testing
