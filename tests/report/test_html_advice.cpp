#include "mrpt_ext/report/html_advice.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_html_advice
{
namespace
{
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
}  // namespace

TEST(ReseedingTable, JoinsWhatFollowsCloselyAndTellsWhy)
{
  RunContext context;
  context.start_time = 1000;
  RunRecord record;
  EXPECT_EQ(reseedingTable(record, context), "");
  record.filter.reseedings = {{1010, "few <inliers>"}, {1012, "later"}, {1100, "again"}};
  const std::string html = reseedingTable(record, context);
  EXPECT_TRUE(contains(html, "10.0 to 12.0 s</th><td>2</td><td>few &lt;inliers&gt;</td>")) << html;
  EXPECT_TRUE(contains(html, "100.0 to 100.0 s</th><td>1</td><td>again</td>")) << html;
}

TEST(ReseedingTable, CountsWhatItDoesNotShow)
{
  RunRecord record;
  for (int k = 0; k < 30; ++k) record.filter.reseedings.push_back({100.0 * k, "reason"});
  EXPECT_TRUE(contains(reseedingTable(record, {}), "10 more"));
}

TEST(AdviceList, SpeaksOfWhatTheRunHas)
{
  RunScore score;
  score.verdict = Verdict::ok;
  score.verdict_shares = {1.0, 0.0, 0.0};
  EXPECT_EQ(adviceList(score), "");
  score.verdict_shares.ambiguous = 0.1;
  EXPECT_TRUE(contains(adviceList(score), "ambiguous, several modes"));
  EXPECT_FALSE(contains(adviceList(score), "lost"));
  score.verdict_shares.lost = 0.1;
  score.filter.reseeds = 3;
  EXPECT_TRUE(contains(adviceList(score), "lost for a while"));
  EXPECT_TRUE(contains(adviceList(score), "injected hypotheses"));
}
}  // namespace mrpt_ext::test_html_advice
