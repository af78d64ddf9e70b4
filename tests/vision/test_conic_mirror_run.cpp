#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/conic_mirror.h"
#include "run_images.h"
#include "scratch_folder.h"

// From rendered images of the conic mirror to edges (ini/images2rawlog/conic-mirror.ini) and poses
// (ini/landmark-localization/conic-mirror.ini); the truth comes with the images (observations.csv).
namespace mrpt_ext::test_conic_mirror_run
{
namespace
{
namespace fs = std::filesystem;

double apart(double a_deg, double b_deg) { return std::abs(radToDeg(wrap(degToRad(a_deg - b_deg)))); }

struct TrueEdge
{
  double azimuth = 0;  // deg
  bool mapped = false;
};

using EdgesByFrame = std::map<int, std::vector<TrueEdge>>;

EdgesByFrame visibleEdges(const fs::path& scene)
{
  const TextTable table(scene / "observations.csv", {});
  EdgesByFrame edges;
  for (std::size_t row = 0; row < table.size(); ++row)
    if (table.integer(row, table.column("visible")) != 0)
      edges[table.integer(row, table.column("frame"))].push_back(
          {table.number(row, table.column("azimuth_deg")), table.integer(row, table.column("mapped")) != 0});
  return edges;
}

/// How the azimuths seen in all frames compare with the truth.
struct Score
{
  int mapped = 0, found = 0, unexplained = 0, isolated = 0;
  double squares = 0;
  [[nodiscard]] double foundShare() const { return static_cast<double>(found) / mapped; }
  [[nodiscard]] double rms() const { return std::sqrt(squares / isolated); }

  void add(const std::vector<TrueEdge>& truth, const std::vector<double>& seen)
  {
    for (const TrueEdge& edge : truth)
    {
      if (!edge.mapped) continue;
      double nearest = 180;
      for (const double azimuth : seen) nearest = std::min(nearest, apart(azimuth, edge.azimuth));
      ++mapped;
      if (nearest >= 1) continue;
      ++found;
      const auto close = std::count_if(truth.begin(), truth.end(),
                                       [&](const TrueEdge& e) { return apart(e.azimuth, edge.azimuth) < 2.5; });
      if (close > 1) continue;
      ++isolated;
      squares += nearest * nearest;
    }
    for (const double azimuth : seen)
      unexplained +=
          std::none_of(truth.begin(), truth.end(), [&](const TrueEdge& e) { return apart(e.azimuth, azimuth) < 1; });
  }
};

/// Scores the table of `--csv`.
Score scoreOf(const fs::path& csv, const EdgesByFrame& truth)
{
  const TextTable table(csv, {});
  std::map<int, std::vector<double>> seen;
  for (std::size_t row = 0; row < table.size(); ++row)
    seen[table.integer(row, table.column("frame"))].push_back(table.number(row, table.column("azimuth_deg")));
  Score score;
  for (const auto& [frame, edges] : truth) score.add(edges, seen[frame]);
  return score;
}

void expectEdgesAndPoses(const fs::path& scene)
{
  const testing::ScratchFolder folder;
  const auto files = testing::logFiles(folder.path(), "log");
  const fs::path csv = folder.path() / "log.csv";
  const auto outcome = testing::runImages({testing::shipped("images2rawlog", "conic-mirror").string(), "-i",
                                           scene.string(), "-o", files.rawlog.string(), "--csv", csv.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto truth = visibleEdges(scene);
  const Score score = scoreOf(csv, truth);
  EXPECT_GE(score.foundShare(), 0.97);
  EXPECT_LE(score.rms(), 0.12);
  EXPECT_LE(score.unexplained, 2.5 * static_cast<double>(truth.size()));

  const auto run = testing::localized(folder.path(), "conic-mirror", files.arguments());
  const auto method = testing::summaryOf(run).at("methods").at("interpretation_tree");
  EXPECT_EQ(method.at("availability"), 1.0);
  EXPECT_LE(method.at("position_error_m").at("median"), 0.01);
  EXPECT_LE(method.at("position_error_m").at("max"), 0.10);
  EXPECT_LE(method.at("heading_error_deg").at("median"), 0.05);
}

/// Other light and twice the noise: the channels times 1.15/1.0/0.8, times 0.7, and noise that doubles the total.
cv::Mat spoiled(const cv::Mat& grey, int seed)
{
  cv::Mat colour, noise(grey.size(), CV_32FC3);
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  colour.convertTo(colour, CV_32FC3, 0.7);
  cv::multiply(colour, cv::Scalar(0.8, 1.0, 1.15), colour);
  cv::RNG(static_cast<std::uint64_t>(seed)).fill(noise, cv::RNG::NORMAL, 0, std::sqrt(3.0) * 3.6);
  colour += noise;
  colour.convertTo(colour, CV_8UC3);
  return colour;
}

std::size_t edgesIn(const cv::Mat& image) { return viewConicMirror(image, {}).edges.size(); }

void expectDetectionsStay(const fs::path& scene)
{
  const TextTable frames(scene / "frames.csv", {});
  std::size_t before = 0, after = 0;
  for (std::size_t row = 0; row < frames.size(); ++row)
  {
    const cv::Mat grey = cv::imread((scene / frames.text(row, frames.column("image"))).string(), cv::IMREAD_GRAYSCALE);
    before += edgesIn(grey);
    after += edgesIn(spoiled(grey, static_cast<int>(row) + 1));
  }
  EXPECT_GE(static_cast<double>(after), 0.9 * static_cast<double>(before));
}

const fs::path kOwnScene = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/conic-mirror";
}  // namespace

TEST(ConicMirrorRun, OwnImagesGiveEdgesAndPoses) { expectEdgesAndPoses(kOwnScene); }

TEST(ConicMirrorRun, OwnImagesKeepTheirEdgesInOtherLight) { expectDetectionsStay(kOwnScene); }

TEST(ConicMirrorRun, SharedImagesGiveEdgesAndPoses)
{
  const auto scene = testing::sharedScene("samples/A_room1");
  if (!scene) GTEST_SKIP() << "the shared scenes are absent";
  expectEdgesAndPoses(*scene);
}

TEST(ConicMirrorRun, SharedImagesKeepTheirEdgesInOtherLight)
{
  const auto scene = testing::sharedScene("samples/A_room1");
  if (!scene) GTEST_SKIP() << "the shared scenes are absent";
  expectDetectionsStay(*scene);
}

TEST(ConicMirrorRun, APhotographGivesEdges)
{
  const auto photograph = testing::sharedScene("real/catadioptric_sample.jpg");
  if (!photograph) GTEST_SKIP() << "the shared scenes are absent";
  const ConicMirrorView view = viewConicMirror(cv::imread(photograph->string()), {});
  ASSERT_TRUE(view.outline) << view.problem;
  // As an independent circle search sees it, to its own accuracy.
  EXPECT_NEAR(view.outline->rim.centre.x, 315.8, 3);
  EXPECT_NEAR(view.outline->rim.centre.y, 216.8, 3);
  EXPECT_NEAR(view.outline->rim.semi_v, 265.6, 4);
  EXPECT_GT(view.edges.size(), 5u);
}
}  // namespace mrpt_ext::test_conic_mirror_run
