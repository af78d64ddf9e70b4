#include "mrpt_ext/app/run_summary_text.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_run_summary_text
{
namespace
{
LocalizationInput sampleInput()
{
  LocalizationInput input;
  input.context.map = LandmarkTable({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {5, 4, 0}}});
  input.context.rawlog_path = "room.rawlog";
  input.context.rawlog_entries = 42;
  input.context.duration_s = 12.3;
  input.context.observations["CObservationA"] = {.total = 30, .used = 30};
  input.context.observations["CObservationB"] = {.total = 10, .used = 7, .ignored = 3};
  input.context.observations["CObservationC"] = {.total = 2, .used = 0, .ignored = 2};
  input.unusable["eye: id not in the map"] = 5;
  input.log.frames = 30;
  input.log.detections = 100;
  return input;
}

PoseEstimate pointAt(double time, int modes, Verdict verdict)
{
  return {.time = time, .pose = {{1, 2, kPi / 2}, {}}, .modes = modes, .verdict = verdict};
}
}  // namespace

TEST(RunSummaryText, ListsWhatIsUsedAndWhatIsNot)
{
  EXPECT_EQ(inputText(sampleInput()),
            "map      2 landmarks in 5.0 x 4.0 m\n"
            "log      room.rawlog: 42 records, 12.3 s\n"
            "             30 CObservationA\n"
            "             10 CObservationB, 3 of them ignored\n"
            "              2 CObservationC (ignored: no likelihood for this class)\n"
            "              5 unusable: eye: id not in the map\n"
            "frames   30, 100 detections\n"
            "truth    none: no errors are computed\n");
}

TEST(RunSummaryText, TellsWhatTheTruthIs)
{
  LocalizationInput input = sampleInput();
  input.context.truth.resize(7);
  EXPECT_NE(inputText(input).find("truth    7 poses\n"), std::string::npos);
  input.context.truth_is_sparse = true;
  EXPECT_NE(inputText(input).find("truth    7 poses, sparse: errors at their own stamps\n"), std::string::npos);
}

TEST(RunSummaryText, LongNamesAreNotCutOff)
{
  LocalizationInput input = sampleInput();
  const std::string long_name(1000, 'x');
  input.context.rawlog_path = long_name;
  input.unusable = {{long_name + " y", 5}};
  input.context.observations = {{long_name + "Z", {.total = 1, .used = 1}}};
  const std::string text = inputText(input);
  EXPECT_NE(text.find(long_name + ": 42 records, 12.3 s\n"), std::string::npos);
  EXPECT_NE(text.find(long_name + " y\n"), std::string::npos);
  EXPECT_NE(text.find(long_name + "Z\n"), std::string::npos);
}

TEST(RunSummaryText, ReportsWhenThePoseBecameUnique)
{
  RunRecord record;
  EXPECT_EQ(ambiguityText(record, 100), "");
  record.methods = {{.name = "particle_filter"}};
  EXPECT_EQ(ambiguityText(record, 100), "");
  record.methods[0].points = {pointAt(100, 4, Verdict::ambiguous), pointAt(103.5, 1, Verdict::ok)};
  EXPECT_EQ(ambiguityText(record, 100),
            "start    4 pose hypotheses after the first frame\n"
            "unique   after 3.5 s, at x 1.00 m, y 2.00 m, heading 90.0 deg\n");
  record.methods[0].points = {pointAt(100, 1, Verdict::ambiguous)};
  EXPECT_EQ(ambiguityText(record, 100),
            "start    1 pose hypothesis after the first frame\n"
            "unique   never: the filter did not reach `ok`\n");
}
}  // namespace mrpt_ext::test_run_summary_text
