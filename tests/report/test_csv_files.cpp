#include <gtest/gtest.h>

#include <sstream>
#include <type_traits>

#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/report/csv_field.h"
#include "mrpt_ext/report/run_csv.h"
#include "mrpt_ext/report/trajectory_tum.h"
#include "scratch_folder.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_csv_files
{
using namespace testing;

namespace
{
std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What a table writes.
template <typename Rows>
std::string textOf(void (*table)(const Rows&, const TextSink&), const std::type_identity_t<Rows>& rows)
{
  std::string text;
  table(rows, [&text](std::string_view piece) { text += piece; });
  return text;
}
}  // namespace

TEST(StepsCsv, ColumnsAndValues)
{
  RunRecord record;
  MethodTrajectory form, filter;
  form.name = "running_fix";
  filter.name = "particle_filter";
  PoseEstimate later, point;
  later.time = 2.5;
  later.heading_known = false;
  point.time = 1.25;
  point.pose.mean = {1, -2, kPi / 2};
  point.pose.covariance = Vector3d(0.01, 0.02, 0.0025).asDiagonal();
  point.modes = 2;
  point.best_weight = 0.75;
  point.effective_samples = 0.5;
  point.verdict = Verdict::ambiguous;
  form.points = {later};
  filter.points = {point};
  record.methods = {form, filter};
  EXPECT_EQ(linesOf(textOf(stepsCsv, record)),
            (std::vector<std::string>{
                "t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict",
                "1.250000,particle_filter,1.000000,-2.000000,90.000000,0.010000000,0.000000000,0.020000000,0.002500000,"
                "2,0.750000,0.500000,ambiguous",
                "2.500000,running_fix,0.000000,0.000000,,0.000000000,0.000000000,0.000000000,,1,1.000000,,ok"}));
}

TEST(StepsCsv, HasEveryEstimateInTheOrderOfTime)
{
  const RunRecord record = syntheticRecord(syntheticContext(20));
  std::size_t estimates = 0;
  for (const MethodTrajectory& method : record.methods) estimates += method.points.size();
  const auto lines = linesOf(textOf(stepsCsv, record));
  ASSERT_EQ(lines.size(), estimates + 1);
  for (std::size_t i = 2; i < lines.size(); ++i) EXPECT_LE(std::stod(lines[i - 1]), std::stod(lines[i]));
}

TEST(HypothesesCsv, ColumnsAndValues)
{
  EXPECT_EQ(textOf(hypothesesCsv, {{3, 1, {0.5, 1, -kPi / 4}, 0.25, "a,\"b\""}}),
            "t,rank,x,y,phi_deg,weight,source\n"
            "3.000000,1,0.500000,1.000000,-45.000000,0.250000,\"a,\"\"b\"\"\"\n");
}

TEST(ObjectsCsv, ColumnsAndValues)
{
  const Matrix2d covariance = (Matrix2d() << 0.04, 0.01, 0.01, 0.09).finished();
  EXPECT_EQ(textOf(objectsCsv, {{3, "ball", {1, 2}, covariance, {3, 4}}}),
            "t,label,x,y,cxx,cxy,cyy,x_robot,y_robot\n"
            "3.000000,ball,1.000000,2.000000,0.040000000,0.010000000,0.090000000,3.000000,4.000000\n");
  EXPECT_EQ(textOf(objectsCsv, {}), "t,label,x,y,cxx,cxy,cyy,x_robot,y_robot\n");
}

TEST(TrajectoryTum, TheLastEstimateOfAStampStays)
{
  MethodTrajectory trajectory;
  for (const double x : {1.0, 2.0, 3.0})
  {
    PoseEstimate point;
    point.time = x < 3 ? 5 : 6;
    point.pose.mean.x = x;
    point.heading_known = x < 3;
    trajectory.points.push_back(point);
  }
  const ScratchFolder folder;
  trajectory.name = "filter";
  writeTrajectoryTum(folder.path(), trajectory);
  const Trajectory written = readTum(folder.path() / "trajectory_filter.tum");
  ASSERT_EQ(written.size(), 2u);
  EXPECT_EQ(written[0].pose.x, 2);
  EXPECT_FALSE(written[1].heading_known);
}

TEST(BiasesCsv, OneRowPerBiasAndFrame)
{
  EXPECT_EQ(textOf(biasesCsv, {{12.5, "stereo.range_scale", 0.05, 0.002}, {12.5, "distance_scale", -0.01, 0.01}}),
            "t,bias,mean,std\n" + timeField(12.5) + ",stereo.range_scale," + lengthField(0.05) + "," +
                lengthField(0.002) + "\n" + timeField(12.5) + ",distance_scale," + lengthField(-0.01) + "," +
                lengthField(0.01) + "\n");
}
}  // namespace mrpt_ext::test_csv_files
