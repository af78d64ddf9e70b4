#include "mrpt_ext/app/live_run.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_live_run
{
namespace
{
using Json = nlohmann::ordered_json;

const LandmarkTable kMap({{1, {0, 0, 0}}, {2, {6, 0, 0}}, {3, {6, 5, 0}}, {4, {0, 5, 0}}});

Pose2 truthAt(double time) { return {2 + 0.3 * time, 1, 0}; }

std::string odometryLine(double time) { return Json{{"t", time}, {"odometry", {0.3 * time, 0, 0}}}.dump() + '\n'; }

std::string detectionsLine(double time)
{
  Json line{{"t", time}, {"sensor", "camera"}, {"mount", {0, 0, 0}}, {"detections", Json::array()}};
  for (const Landmark& landmark : kMap.all())
    line["detections"].push_back({{"id", landmark.id},
                                  {"bearing_deg", radToDeg(predictBearing(truthAt(time), landmark.position.head<2>()))},
                                  {"std_bearing_deg", 1}});
  return line.dump() + '\n';
}

std::string driveUntil(double end)
{
  std::string lines;
  for (int k = 0; 0.2 * k <= end; ++k) lines += odometryLine(0.2 * k) + detectionsLine(0.2 * k);
  return lines;
}

class LiveRunTest : public ::testing::Test
{
 protected:
  LiveRunTest()
  {
    writeLandmarks();
    settings_ = Settings::parse(
        "[LocalizationExperiment]\nparticles_count = 500\ninitial_particles_count = 4000\n"
        "[MetricMap_landmarkMap2D_00_creationOpts]\nlandmarks_file = map.csv\n",
        folder_.path() / "live.ini", localizationKeys());
  }

  void writeLandmarks()
  {
    std::string text = "id,x,y\n";
    for (const Landmark& landmark : kMap.all())
      text += std::to_string(landmark.id) + ',' + std::to_string(landmark.position.x()) + ',' +
              std::to_string(landmark.position.y()) + '\n';
    folder_.write("map.csv", text);
  }

  /// Runs over the lines; returns those of the output.
  std::vector<Json> run(const std::string& input)
  {
    std::istringstream in(input);
    std::ostringstream out;
    exit_code_ = runLive(*settings_, in, out);
    std::vector<Json> lines;
    std::istringstream text(out.str());
    for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
    return lines;
  }

  testing::ScratchFolder folder_;
  std::optional<Settings> settings_;
  int exit_code_ = -1;
};

std::vector<Json> errorsOf(const std::vector<Json>& lines)
{
  std::vector<Json> errors;
  for (const Json& line : lines)
    if (line.contains("error")) errors.push_back(line);
  return errors;
}
}  // namespace

TEST_F(LiveRunTest, EstimatesAndASummaryAreLines)
{
  const std::vector<Json> lines = run(driveUntil(4));
  EXPECT_EQ(exit_code_, kExitDone);
  ASSERT_EQ(lines.size(), 22U) << "21 estimates and the end";
  const Json& last = lines[20];
  EXPECT_NEAR(last["t"].get<double>(), 4, 1e-9);
  EXPECT_EQ(last["verdict"], "ok") << last["reason"];
  EXPECT_NEAR(last["x"].get<double>(), truthAt(4).x, 0.1);
  EXPECT_NEAR(last["phi_deg"].get<double>(), 0, 3);
  EXPECT_EQ(last["covariance"].size(), 6U);
  EXPECT_GE(last["modes"].size(), 1U);
  const Json& end = lines[21]["end"];
  EXPECT_EQ(end["lines"], 42);
  EXPECT_EQ(end["estimates"], 21);
  EXPECT_EQ(end["errors"], 0);
  EXPECT_EQ(last["steps_late"], 0);
  EXPECT_EQ(end["late"], (Json{{"estimates", 0}, {"most_steps", 0}}));
  EXPECT_GE(end["latency_ms"]["max"].get<double>(), end["latency_ms"]["median"].get<double>());
  EXPECT_GT(end["latency_ms"]["median"].get<double>(), 0);
}

TEST_F(LiveRunTest, AMistakeIsALineAndTheOthersCount)
{
  const std::string whole = driveUntil(2);
  const std::vector<Json> lines =
      run("no json\n" + whole + "{\"t\": 3, \"odometry\": [1, 2]}\n\n" + driveUntil(4).substr(whole.size()));
  EXPECT_EQ(exit_code_, kExitFailed);
  const std::vector<Json> errors = errorsOf(lines);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0]["line"], 1);
  EXPECT_EQ(errors[1]["line"], 24);
  EXPECT_EQ(errors[1]["error"], "line: 'odometry': expected [3 numbers]");
  EXPECT_EQ(lines.back()["end"]["estimates"], 21);
}

TEST_F(LiveRunTest, EveryMistakeSaysWhatIsExpected)
{
  const std::map<std::string, std::string> mistakes = {
      {"[1]", "line: expected an object {...}"},
      {R"({"t": 1})", "line: expected 'odometry', 'velocity', 'detections', 'reset' or 'map'"},
      {R"({"odometry": [0, 0, 0]})", "line: 't' is missing"},
      {R"({"t": "1", "odometry": [0, 0, 0]})", "line: 't': expected a number"},
      {R"({"t": 1, "odometry": [0, 1e9, 0]})", ""},
      {R"({"t": 1, "odometry": [0, 0, 0], "speed": 3})", "line: unknown member 'speed'"},
      {R"({"t": 1, "detections": []})", "line: 'sensor': expected the name of the sensor"},
      {R"({"t": 1, "sensor": "a", "detections": [{"id": -4, "range_m": 1, "std_range_m": 1}]})",
       "detection: 'id': expected a number from 0 to 2000000000"},
      {R"({"t": 1, "sensor": "a", "detections": [{"id": 4}]})", "detection: expected 'bearing_deg' or 'range_m'"},
      {R"({"t": 1, "sensor": "a", "detections": [{"bearing_deg": 4}]})", "detection: 'std_bearing_deg' is missing"},
      {R"({"t": 1, "sensor": "a", "detections": [{"range_m": 4, "std_range_m": 0}]})",
       "detection: 'std_range_m': expected a standard deviation > 0"},
      {R"({"t": 1, "odometry": [0, 0, 0], "odometry_rad": [0, 0, 0]})",
       "line: 'odometry' and 'odometry_rad': expected one of them"},
      {R"({"t": 1, "sensor": "a", "detections": [{"bearing_deg": 4, "std_bearing_deg": 1, "bearing_rad": 4}]})",
       "detection: 'bearing_deg' and 'bearing_rad': expected one of them"},
      {R"({"t": 1, "sensor": "a", "detections": [], "horizontal": 1})", "line: 'horizontal': expected true or false"},
      {R"({"t": 1, "sensor": "a", "detections": [], "field_of_view_deg": 0})",
       "line: 'field_of_view_deg': expected an angle > 0"},
      {R"({"t": 1, "sensor": "a", "detections": [], "max_range_m": -1})",
       "line: 'max_range_m': expected a distance > 0"},
      {R"({"t": 1, "reset": "home"})", "line: 'reset': expected [3 numbers]"},
      {R"({"map": [{"id": 1, "x": 1, "y": 2}, {"id": 1, "x": 3, "y": 2}]})", ""},
      {R"({"map": [{"id": 1, "x": 1}]})", "landmark: 'y' is missing"}};
  for (const auto& [line, message] : mistakes)
  {
    const std::vector<Json> errors = errorsOf(run(line + '\n'));
    ASSERT_EQ(errors.size(), 1U) << line;
    if (!message.empty())
    {
      EXPECT_EQ(errors[0]["error"], message) << line;
    }
  }
}

// 90 degrees are the same double both ways.
TEST_F(LiveRunTest, AnglesMayBeRadians)
{
  const auto lineWith = [](const std::string& odometry, const std::string& mount, const std::string& bearing)
  {
    return "{\"t\": 1, \"reset" + mount + "}\n{\"t\": 1, \"odometry" + odometry +
           "}\n{\"t\": 1, \"sensor\": \"camera\", \"mount" + mount + ", \"detections\": [{\"id\": 1, \"bearing" +
           bearing + "}]}\n";
  };
  const std::vector<Json> degrees =
      run(lineWith("\": [0, 0, 90]", "\": [3, 1, 90]", "_deg\": 90, \"std_bearing_deg\": 90"));
  const std::string quarter = Json(degToRad(90)).dump();
  const std::vector<Json> radians = run(lineWith("_rad\": [0, 0, " + quarter + "]", "_rad\": [3, 1, " + quarter + "]",
                                                 "_rad\": " + quarter + ", \"std_bearing_rad\": " + quarter));
  ASSERT_EQ(degrees.size(), 2U) << degrees[0];
  ASSERT_EQ(radians.size(), 2U) << radians[0];
  for (const char* key : {"x", "y", "phi_deg", "covariance", "modes"}) EXPECT_EQ(degrees[0][key], radians[0][key]);
}

// Of an anonymous detection the landmarks out of view are no candidates.
TEST_F(LiveRunTest, WhatASensorSeesIsPartOfItsLine)
{
  const auto reasonWith = [&](const std::string& limits)
  {
    std::string lines = R"({"t": 0, "reset": [3, 2.5, 0]})"
                        "\n";
    for (int k = 0; k < 5; ++k)
      lines += R"({"t": )" + std::to_string(k) +
               R"(, "sensor": "camera", "detections": [{"bearing_deg": 39.8, "std_bearing_deg": 1}])" + limits + "}\n";
    const std::vector<Json> answers = run(lines);
    EXPECT_TRUE(errorsOf(answers).empty());
    return answers[4]["reason"].get<std::string>();
  };
  EXPECT_NE(reasonWith(""), reasonWith(R"(, "max_range_m": 1)"));
}

TEST_F(LiveRunTest, ResetAndMapAreTaken)
{
  const std::vector<Json> lines =
      run(R"({"t": 0, "reset": [2, 1, 0], "std_m": 0.05, "std_deg": 1})"
          "\n" +
          driveUntil(1) +
          R"({"map": [{"id": 7, "x": 6, "y": 3, "category": "pole"}]})"
          "\n" +
          R"({"t": 1.2, "reset": "unknown"})"
          "\n" +
          odometryLine(1.4) +
          R"({"t": 1.4, "sensor": "camera", "detections": [{"id": 7, "bearing_deg": 20, "std_bearing_deg": 1}]})"
          "\n");
  EXPECT_TRUE(errorsOf(lines).empty()) << errorsOf(lines)[0];
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[0]["modes"].size(), 1U) << "the start is known";
  EXPECT_NE(lines[6]["verdict"], "ok") << "one bearing does not tell the pose";
}

TEST_F(LiveRunTest, OneTagThatFacesAKnownDirectionTellsThePose)
{
  const auto bestWith = [&](const std::string& seen)
  {
    const std::vector<Json> lines =
        run(R"({"map": [{"id": 7, "x": 6, "y": 3, "yaw_deg": 180, "std_yaw_deg": 1}]})"
            "\n" +
            odometryLine(0) +
            R"({"t": 0, "sensor": "camera", "detections": [{"id": 7, "bearing_deg": 20, "std_bearing_deg": 0.1, )"
            R"("range_m": 3, "std_range_m": 0.02)" +
            seen + "}]}\n");
    EXPECT_TRUE(errorsOf(lines).empty()) << errorsOf(lines)[0];
    return lines.at(0).at("modes").at(0);
  };
  EXPECT_LT(bestWith("").at("weight"), 0.1) << "anywhere around the tag";
  const Json best = bestWith(R"(, "yaw_deg": 170, "std_yaw_deg": 2)");
  EXPECT_GT(best.at("weight"), 0.5);
  EXPECT_NEAR(best.at("phi_deg").get<double>(), 10, 3) << "180 - 170";
  const auto mistake = [&](const std::string& seen)
  {
    const auto lines =
        run(R"({"t": 0, "sensor": "camera", "detections": [{"id": 7, "bearing_deg": 20, "std_bearing_deg": 1)" + seen +
            "}]}\n");
    return errorsOf(lines).at(0).at("error").get<std::string>();
  };
  EXPECT_NE(mistake(R"(, "yaw_deg": 170)").find("'std_yaw_deg' is missing"), std::string::npos);
  EXPECT_NE(mistake(R"(, "other_yaw_deg": 170, "other_std_yaw_deg": 1)").find("without 'yaw_deg'"), std::string::npos);
}
}  // namespace mrpt_ext::test_live_run
