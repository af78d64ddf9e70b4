#include <gtest/gtest.h>

#include "scratch_folder.h"
#include "test_length.h"
#include "whole_runs.h"

// The same random seed gives the same bytes, however often and on however many threads.
namespace mrpt_ext::test_determinism
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;
using Content = std::map<std::string, std::string>;

void expectSame(const Content& a, const Content& b)
{
  EXPECT_EQ(a.size(), b.size());
  for (const auto& [name, bytes] : a)
  {
    const auto other = b.find(name);
    ASSERT_NE(other, b.end()) << name << " is only in one of them";
    EXPECT_TRUE(bytes == other->second) << name << " differs";
  }
}

/// Anonymous bearings from an unknown start: the interpretation tree, thousands of particles, many modes.
Arguments roomArguments()
{
  const std::string section = "LocalizationExperiment.";
  if (testing::isShort())
    return {
        "--duration", "5", "--set", section + "initial_particles_count=1000", "--set", section + "particles_count=200"};
  return {"--duration", "14", "--set", section + "initial_particles_count=4000"};
}

class Determinism : public ::testing::Test
{
 protected:
  /// Runs into a folder of its own and returns what has to be reproducible.
  Content contentOf(const Arguments& more, const std::string& name = "room")
  {
    const fs::path place = folder_.path() / std::to_string(++count_);
    fs::create_directory(place);
    return testing::reproducibleContent(testing::localized(place, name, more));
  }

  testing::ScratchFolder folder_;
  int count_ = 0;
};
}  // namespace

TEST_F(Determinism, ThreeRunsAndBlocksOnTwoThreads)
{
  const Content first = contentOf(roomArguments());
  EXPECT_GE(first.size(), 6U);
  EXPECT_GT(first.at("steps.csv").size(), 2000U);
  expectSame(first, contentOf(roomArguments()));
  if (!testing::isShort()) expectSame(first, contentOf(roomArguments()));
  expectSame(first, contentOf(testing::joined(roomArguments(), {"--jobs", "2"})));
}

TEST_F(Determinism, AnotherSeedIsAnotherRun)
{
  const Content one = contentOf(roomArguments());
  const Content two = contentOf(testing::joined(roomArguments(), {"--seed", "2"}));
  EXPECT_FALSE(one.at("trajectory_particle_filter.tum") == two.at("trajectory_particle_filter.tum"));
  EXPECT_FALSE(one.at("config_resolved.ini") == two.at("config_resolved.ini"));
  // Closed forms draw nothing.
  EXPECT_TRUE(one.at("trajectory_interpretation_tree.tum") == two.at("trajectory_interpretation_tree.tum"));
}

TEST_F(Determinism, TrialsOnOneOrTwoThreads)
{
  const Content one = contentOf(testing::joined(roomArguments(), {"--repeat", "2", "--jobs", "1"}));
  const Content two = contentOf(testing::joined(roomArguments(), {"--repeat", "2", "--jobs", "2"}));
  expectSame(one, two);
  EXPECT_FALSE(one.at("trial_000/steps.csv") == one.at("trial_001/steps.csv")) << "trials are independent";
}

TEST_F(Determinism, TrialsOfALongerStudyAreTheSameTrials)
{
  const Arguments brief{"--duration", "15"};
  const Content all = contentOf(testing::joined(brief, {"--repeat", "3"}), "half-field");
  const Content part = contentOf(testing::joined(brief, {"--trials", "1:3"}), "half-field");
  int compared = 0;
  for (const auto& [name, bytes] : part)
  {
    if (!name.starts_with("trial_")) continue;
    ASSERT_TRUE(all.contains(name)) << name;
    EXPECT_TRUE(all.at(name) == bytes) << name << " differs";
    ++compared;
  }
  EXPECT_FALSE(part.contains("trial_000/steps.csv"));
  EXPECT_TRUE(part.contains("trial_001/summary.json"));
  EXPECT_TRUE(part.contains("trial_002/summary.json"));
  EXPECT_GE(compared, 2 * 5);
}

// A study that was killed and resumed leaves what one that ran through leaves.
TEST_F(Determinism, AResumedStudyIsTheWholeStudy)
{
  const Arguments brief{"--duration", "15", "--repeat", "3"};
  const fs::path whole = testing::localized(folder_.path() / "whole", "half-field", brief);
  const fs::path killed = folder_.path() / "killed" / "half-field";
  fs::create_directories(killed.parent_path());
  fs::copy(whole, killed, fs::copy_options::recursive);
  for (const char* last :
       {"summary.json", "report.html", "trial_001/summary.json", "trial_001/trajectory_odometry.tum"})
    EXPECT_TRUE(fs::remove(killed / last)) << last;
  fs::remove_all(killed / "trial_002");
  const auto untouched = fs::last_write_time(killed / "trial_000" / "summary.json");

  const Arguments resume = testing::joined(brief, {"--resume"});
  testing::localized(killed.parent_path(), "half-field", resume);
  expectSame(testing::reproducibleContent(whole), testing::reproducibleContent(killed));
  EXPECT_EQ(fs::last_write_time(killed / "trial_000" / "summary.json"), untouched) << "it was finished";

  const auto other = testing::localize(
      testing::joined({testing::shipped("landmark-localization", "half-field"), "-o", killed, "--seed", "7"}, resume));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("has other settings"), std::string::npos) << other.err;
}

TEST_F(Determinism, ReferenceEngine)
{
  const auto log = testing::simulated(folder_.path(), "tracking", {"--set", "Simulation.duration_s=5"});
  const Arguments arguments =
      testing::joined(log.arguments(), {"--set", "LocalizationExperiment.filter_engine=mrpt", "--repeat", "3"});
  const Content one = contentOf(arguments, "tracking");
  expectSame(one, contentOf(testing::joined(arguments, {"--jobs", "2"}), "tracking"));
  EXPECT_FALSE(one.at("trial_000/steps.csv") == one.at("trial_002/steps.csv"));
}
}  // namespace mrpt_ext::test_determinism
