#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/html_page.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/html_text.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_html_report
{
using namespace testing;

namespace
{
/// The first error in the nesting of the tags; empty when every tag is closed in order, as in XML.
std::string nestingError(const std::string& html)
{
  static const std::regex kTag("<(/?)([a-zA-Z0-9]+)((?:\\s+[a-zA-Z-]+=\"[^\"<>]*\")*)\\s*(/?)>");
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (auto tag = std::sregex_iterator(html.begin(), html.end(), kTag); tag != std::sregex_iterator(); ++tag, ++tags)
  {
    const std::string name = (*tag)[2];
    if ((*tag)[4].length() > 0) continue;
    if ((*tag)[1].length() == 0)
      open.push_back(name);
    else if (open.empty() || open.back() != name)
      return "</" + name + "> closes <" + (open.empty() ? "" : open.back()) + ">";
    else
      open.pop_back();
  }
  if (!open.empty()) return "<" + open.back() + "> is not closed";
  const auto brackets = static_cast<std::size_t>(std::count(html.begin(), html.end(), '<'));
  return brackets == tags + 1 ? "" : "a bracket that belongs to no tag";  // + 1: <!DOCTYPE html>
}

/// The page without the contents of its script elements.
std::string withoutScripts(const std::string& html)
{
  std::string kept;
  std::size_t at = 0;
  for (auto open = html.find("<script"); open != std::string::npos; open = html.find("<script", at))
  {
    const auto begin = html.find('>', open) + 1;
    kept += html.substr(at, begin - at);
    at = html.find("</script>", begin);
  }
  return kept + html.substr(at);
}

/// Data of the scripts.
nlohmann::json dataOf(const std::string& html)
{
  const std::string start = "<script type=\"application/json\" id=\"run-data\">";
  const auto begin = html.find(start) + start.size();
  return nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

bool showsNan(const std::string& html) { return std::regex_search(html, std::regex("\\b(nan|inf)\\b")); }

std::string pageOf(const RunContext& context, const RunRecord& record)
{
  return trialPage(context, withAlignedOdometry(record, context.truth), scoreRun(context, record, {}));
}

std::size_t countOf(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

RunScore mergedScore(const RunContext& context)
{
  std::vector<RunScore> scores;
  for (int trial = 0; trial < 12; ++trial) scores.push_back(scoreRun(context, syntheticRecord(context, trial), {}));
  return mergeScores(scores);
}
}  // namespace

TEST(NestingError, FindsErrors)
{
  EXPECT_EQ(nestingError("<!DOCTYPE html><p>a<br/></p>"), "");
  EXPECT_NE(nestingError("<!DOCTYPE html><p><b></p></b>"), "");
  EXPECT_NE(nestingError("<!DOCTYPE html><p>"), "");
  EXPECT_NE(nestingError("<!DOCTYPE html><p>1 < 2</p>"), "");
}

TEST(EscapeHtml, TextNeverBecomesMarkup)
{
  EXPECT_EQ(escapeHtml("<a b=\"c\">&'"), "&lt;a b=&quot;c&quot;&gt;&amp;&#39;");
  EXPECT_EQ(escapeHtml(std::string("a\x01z")), "a z");
}

TEST(BreakableName, MayBreakAfterUnderscores) { EXPECT_EQ(breakableName("two_<b>"), "two_<wbr/>&lt;b&gt;"); }

TEST(MethodClass, ColoursAreStableAndSharedWithTheOracle)
{
  const std::vector<std::string> names{"odometry", "running_fix", "oracle_interpretation_tree", "interpretation_tree"};
  EXPECT_EQ(methodClass("particle_filter", names), "filter");
  EXPECT_EQ(methodClass("running_fix", names), "form-1");
  EXPECT_EQ(methodClass("interpretation_tree", names), "form-2");
  EXPECT_EQ(methodClass("oracle_interpretation_tree", names), "form-2");
}

TEST(TrialPage, IsWellFormedAndSelfContained)
{
  const RunContext context = syntheticContext();
  const std::string html = pageOf(context, syntheticRecord(context));
  EXPECT_EQ(nestingError(withoutScripts(html)), "");
  EXPECT_EQ(html.find("http:"), std::string::npos);
  EXPECT_EQ(html.find("https:"), std::string::npos);
  EXPECT_EQ(html.find("sourceMappingURL"), std::string::npos);
  EXPECT_EQ(html.find("url("), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(countOf(html, "<script"), 3u);
  EXPECT_FALSE(showsNan(withoutScripts(html)));
}

TEST(TrialPage, HoldsTheDataOfItsChartsAndItsPlayback)
{
  const RunContext context = syntheticContext();
  const nlohmann::json data = dataOf(pageOf(context, syntheticRecord(context)));
  const std::size_t steps = data["playback"]["t"].size();
  EXPECT_GT(steps, 200u);
  for (const char* rows : {"modes", "detections", "objects"}) EXPECT_EQ(data["playback"][rows].size(), steps) << rows;
  EXPECT_EQ(data["playback"]["truth"].size(), 3 * steps);
  EXPECT_EQ(data["playback"]["particles"]["counts"].size(), steps);
  EXPECT_EQ(data["playback"]["particles"]["boxes"].size(), 4 * steps);
  EXPECT_EQ(data["landmarks"].size(), 8u);
  EXPECT_EQ(data["errors"]["position"].size(), data["methods"].size());
  EXPECT_EQ(data["confidence"]["reseeds"].size(), 2u);
  EXPECT_EQ(data["confidence"]["lost"].size(), 1u);
  EXPECT_EQ(data["confidence"]["ambiguous"].size(), 1u);
  EXPECT_GT(data["nees"]["value"].size(), 100u);
  EXPECT_EQ(data["geometry"].size(), 3u);
  EXPECT_EQ(data["residuals"]["ids"].size(), 8u);
}

TEST(TrialPage, OfFiveHundredStepsWithThreeHundredParticlesIsBelowTwoMegabytes)
{
  const RunContext context = syntheticContext(300);
  RunRecord record = syntheticRecord(context);
  record.playback = syntheticPlayback(record.methods.back(), 500, 300);
  ASSERT_EQ(record.playback.size(), 500u);
  EXPECT_LT(pageOf(context, record).size(), 2u << 20);
}

TEST(TrialPage, ShowsEveryPart)
{
  const RunContext context = syntheticContext();
  const std::string html = pageOf(context, syntheticRecord(context));
  EXPECT_NE(html.find("verdict ok"), std::string::npos);
  EXPECT_NE(html.find("one mode holds 0.93"), std::string::npos);
  EXPECT_EQ(countOf(html, "<path class=\"landmark"), 8u);
  EXPECT_EQ(countOf(html, "landmark warned"), 1u);
  EXPECT_EQ(countOf(html, "<ellipse class=\"mode\""), 2u);
  for (const char* chart : {"position", "heading", "confidence", "nees", "residuals"})
    EXPECT_EQ(countOf(html, "data-chart=\"" + std::string(chart) + "\""), 1u) << chart;
  EXPECT_EQ(countOf(html, "data-chart=\"geometry\""), 3u);
  EXPECT_EQ(countOf(html, "<noscript>"), 8u);
  for (const char* part :
       {"few inliers", "CObservationImage", "ground truth", "class=\"scale\"", "uses the truth", "95 % interval",
        "landmarks in view", "Covariance consistency (NEES)", "map, SHA-256", "id=\"step-slider\""})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  for (const MethodTrajectory& method : syntheticRecord(context).methods)
    EXPECT_NE(html.find(method.name), std::string::npos) << method.name;
}

TEST(TrialPage, EscapesTextOfTheUser)
{
  const RunContext context = syntheticContext();
  RunRecord record = syntheticRecord(context);
  record.verdict_reason = "<script>alert(1)</script>";
  const std::string html = pageOf(context, record);
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;&amp;&quot;x&quot;&lt;/b&gt;"), std::string::npos);
}

TEST(TrialPage, TextOfTheLogDoesNotEndTheData)
{
  RunContext context = syntheticContext();
  context.map = LandmarkTable({{1, {0, 0, 0}, "</script><script>alert(1)</script>", {0, 0}}});
  const std::string html = pageOf(context, syntheticRecord(context));
  EXPECT_EQ(countOf(html, "<script"), 3u);
  EXPECT_EQ(dataOf(html)["landmarks"][0][3], "</script><script>alert(1)</script>");
}

TEST(TrialPage, OfAnEmptyRunIsStillAPage)
{
  RunRecord record;
  record.interrupted = true;
  const std::string html = withoutScripts(pageOf(RunContext{}, record));
  EXPECT_EQ(nestingError(html), "");
  EXPECT_NE(html.find("Interrupted"), std::string::npos);
  EXPECT_FALSE(showsNan(html));
}

TEST(TrialPage, OfALongRunStaysSmall)
{
  const RunContext context = syntheticContext(6 * 3600);
  const std::string html = pageOf(context, syntheticRecord(context));
  EXPECT_LT(html.size(), 2u << 20);
}

TEST(MergedPage, LinksToItsTrials)
{
  const RunContext context = syntheticContext(30);
  const std::string html = mergedPage(context, mergedScore(context));
  EXPECT_EQ(nestingError(withoutScripts(html)), "");
  EXPECT_EQ(html.find("http:"), std::string::npos);
  EXPECT_EQ(countOf(html, "data-chart="), 1u);
  EXPECT_EQ(dataOf(html)["residuals"]["ids"].size(), 8u);
  EXPECT_NE(html.find("href=\"trial_000/report.html\""), std::string::npos);
  EXPECT_NE(html.find("href=\"trial_011/report.html\""), std::string::npos);
  EXPECT_NE(html.find("12 trials: success rate 1.00, 0 lost"), std::string::npos);
}

TEST(MergedPage, WithoutResidualsNeedsNoScripts)
{
  RunScore merged = mergedScore(syntheticContext(30));
  merged.landmarks.clear();
  EXPECT_EQ(mergedPage(syntheticContext(30), merged).find("<script"), std::string::npos);
}

TEST(TrialFolder, HasThreeDigitsOrMore)
{
  EXPECT_EQ(trialFolder(7), "trial_007");
  EXPECT_EQ(trialFolder(1234), "trial_1234");
}
}  // namespace mrpt_ext::test_html_report
