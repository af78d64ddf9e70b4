#include "mrpt_ext/evaluation/errors_by_geometry.h"

#include <gtest/gtest.h>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::test_errors_by_geometry
{
namespace
{
/// A closed form that is wrong by 1 m where two landmarks are seen, by 0.1 m where three are, and silent at one.
struct FailingMethod
{
  RunContext context;
  RunRecord record;
  RunScore score;

  FailingMethod()
  {
    context.start_time = 100;
    context.duration_s = 60;
    MethodTrajectory trajectory;
    trajectory.name = "range_least_squares";
    for (int i = 1; i <= 60; ++i)
    {
      const double time = 100 + i;
      context.truth.push_back({time, {0, 0, 0}, true});
      const auto landmarks = static_cast<std::size_t>(1 + i % 3);
      context.geometry.push_back({time, landmarks, landmarks > 1 ? std::optional(degToRad(45)) : std::nullopt, 4.5});
      if (landmarks == 1) continue;
      PoseEstimate point;
      point.time = time;
      point.pose.mean.x = landmarks == 2 ? 1.0 : 0.1;
      trajectory.points.push_back(point);
    }
    record.methods = {trajectory};
    score = scoreRun(context, record, {});
  }
};
}  // namespace

TEST(ErrorsByGeometry, ShowWhereAMethodFails)
{
  const FailingMethod run;
  const auto tables = errorsByGeometry(run.context, run.record, run.score);
  ASSERT_EQ(tables.size(), 3u);
  const auto& classes = tables[0].classes;
  ASSERT_EQ(classes.size(), 3u);
  EXPECT_EQ(classes[0].label, "1");
  EXPECT_EQ(classes[0].frames, 20u);
  EXPECT_EQ(classes[0].methods[0].estimated, 0.0);
  EXPECT_FALSE(classes[0].methods[0].median);
  EXPECT_NEAR(*classes[1].methods[0].median, 1.0, 1e-12);
  EXPECT_NEAR(*classes[2].methods[0].median, 0.1, 1e-12);
  EXPECT_EQ(classes[2].methods[0].estimated, 1.0);
  EXPECT_EQ(classes[2].methods[0].judged, 20u);
}

TEST(ErrorsByGeometry, QuantitiesAreSortedIntoTheirClasses)
{
  const FailingMethod run;
  const auto tables = errorsByGeometry(run.context, run.record, run.score);
  ASSERT_EQ(tables.size(), 3u);
  ASSERT_EQ(tables[1].classes.size(), 1u);
  EXPECT_EQ(tables[1].classes[0].label, "30 to 60");
  EXPECT_EQ(tables[1].classes[0].frames, 40u);
  ASSERT_EQ(tables[2].classes.size(), 1u);
  EXPECT_EQ(tables[2].classes[0].label, "4 to 5");
}

TEST(ErrorsByGeometry, WithoutTruthAreEmpty)
{
  FailingMethod run;
  run.context.truth.clear();
  run.score = scoreRun(run.context, run.record, {});
  EXPECT_TRUE(errorsByGeometry(run.context, run.record, run.score).empty());
}
}  // namespace mrpt_ext::test_errors_by_geometry
