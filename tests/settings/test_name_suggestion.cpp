#include "mrpt_ext/settings/name_suggestion.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_name_suggestion
{
TEST(NameSuggestion, CountsSingleLetterChanges)
{
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
  EXPECT_EQ(editDistance("Seed", "seed"), 0U) << "upper and lower case are the same";
  EXPECT_EQ(editDistance("", "abc"), 3U);
}

TEST(NameSuggestion, NearestNamesFirst)
{
  const std::vector<std::string> names{"max_range_m", "min_range_m", "mode", "scale_range", "std_range_m"};
  EXPECT_EQ(similarNames("max_rnge_m", names), (std::vector<std::string>{"max_range_m", "min_range_m"}));
  EXPECT_EQ(similarNames("range", names), (std::vector<std::string>{"max_range_m", "min_range_m", "scale_range"}))
      << "names that contain the word, three at most";
  EXPECT_TRUE(similarNames("zzz", names).empty());
  EXPECT_EQ(closestName("mod", names), "mode");
  EXPECT_FALSE(closestName("zzz", names));
}
}  // namespace mrpt_ext::test_name_suggestion
