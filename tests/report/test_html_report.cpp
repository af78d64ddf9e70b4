#include <gtest/gtest.h>

#include <regex>

#include "mrpt_ext/evaluation/odometry_anchor.h"
#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/report/html_page.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/html_text.h"
#include "synthetic_run.h"

namespace mrpt_ext
{
using namespace testing;

namespace
{
/// What is wrong with the nesting of the tags; empty when every tag is closed in order, as in XML.
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

bool showsNan(const std::string& html) { return std::regex_search(html, std::regex("\\b(nan|inf)\\b")); }

std::string pageOf(const RunContext& context, const RunRecord& record)
{
  return trialPage(context, withAnchoredOdometry(record, context.truth), scoreRun(context, record, {}));
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

TEST(NestingError, SeesWhatIsWrong)
{
  EXPECT_EQ(nestingError("<!DOCTYPE html><p>a<br/></p>"), "");
  EXPECT_NE(nestingError("<!DOCTYPE html><p><b></p></b>"), "");
  EXPECT_NE(nestingError("<!DOCTYPE html><p>"), "");
  EXPECT_NE(nestingError("<!DOCTYPE html><p>1 < 2</p>"), "");
}

TEST(EscapeHtml, NothingOfTheTextBecomesMarkup)
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
  EXPECT_EQ(nestingError(html), "");
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("url("), std::string::npos);
  EXPECT_FALSE(showsNan(html));
}

TEST(TrialPage, ShowsEveryPart)
{
  const RunContext context = syntheticContext();
  const std::string html = pageOf(context, syntheticRecord(context));
  EXPECT_NE(html.find("verdict ok"), std::string::npos);
  EXPECT_NE(html.find("one mode holds 0.93"), std::string::npos);
  EXPECT_EQ(countOf(html, "<path class=\"landmark"), 8u);
  EXPECT_EQ(countOf(html, "landmark doubtful"), 1u);
  EXPECT_EQ(countOf(html, "<ellipse class=\"mode\""), 2u);
  EXPECT_EQ(countOf(html, "<path class=\"reseed\""), 2u);
  EXPECT_EQ(countOf(html, "<svg class=\"chart\""), 3u);
  for (const char* part : {"few inliers", "CObservationImage", "ground truth", "class=\"scale\"", "logarithmic",
                           "span lost", "span ambiguous", "used the truth"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  for (const MethodTrack& method : syntheticRecord(context).methods)
    EXPECT_NE(html.find(method.name), std::string::npos) << method.name;
}

TEST(TrialPage, EscapesWhatTheUserWrote)
{
  const RunContext context = syntheticContext();
  RunRecord record = syntheticRecord(context);
  record.verdict_reason = "<script>alert(1)</script>";
  const std::string html = pageOf(context, record);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;&amp;&quot;x&quot;&lt;/b&gt;"), std::string::npos);
}

TEST(TrialPage, OfAnEmptyRunIsStillAPage)
{
  RunRecord record;
  record.interrupted = true;
  const std::string html = pageOf(RunContext{}, record);
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
  EXPECT_EQ(nestingError(html), "");
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_NE(html.find("href=\"trial_000/report.html\""), std::string::npos);
  EXPECT_NE(html.find("href=\"trial_011/report.html\""), std::string::npos);
  EXPECT_NE(html.find("12 trials: success rate 1.00, 0 lost"), std::string::npos);
}

TEST(TrialFolder, HasThreeDigitsOrMore)
{
  EXPECT_EQ(trialFolder(7), "trial_007");
  EXPECT_EQ(trialFolder(1234), "trial_1234");
}
}  // namespace mrpt_ext
