#include "mrpt_ext/likelihood/reading_scorer.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

// The batch in single precision against the double-precision likelihood of each pose.
namespace mrpt_ext::test_reading_scorer
{
namespace
{
constexpr std::size_t kRobots = 1500;  // more than a block of tiles, and no whole number of them
const Vector2d kOrigin(400, -300);

/// What a reading may have, switched on one at a time and together.
struct Options
{
  std::string name;
  bool bearing = true, range = false;
  bool identified = true, categories = false, unknown_ids = false;
  bool offset = false, sensor_covariance = false, slant = false, uncertain_map = false, own_clutter = false;
  bool field_of_view = false, max_range = false, missed = false;
  bool biased = false;
  double std_bearing = 0.02, std_range = 0.1, clutter = 0.05;
  double spread = 0.3;  ///< [m] of the robots
  std::size_t landmarks = 40;
};

struct Scene
{
  LandmarkTable map;
  LandmarkClutter clutter;
  Reading reading;
  PoseColumns robots{kOrigin};
  BiasModel bias_states;
  std::vector<std::vector<float>> bias;

  [[nodiscard]] PoseBatch batch() const
  {
    PoseBatch batch = robots.batch();
    batch.bias_states = bias_states;
    for (const auto& column : bias) batch.bias.emplace_back(column);
    return batch;
  }
};

LandmarkTable mapOf(const Options& options, RandomStream& random)
{
  std::vector<Landmark> landmarks;
  for (std::size_t j = 0; j < options.landmarks; ++j)
  {
    Landmark landmark{.id = static_cast<int>(j)};
    landmark.position = {kOrigin.x() + random.uniform(-20, 20), kOrigin.y() + random.uniform(-20, 20),
                         options.slant ? random.uniform(0, 4) : 0.0};
    if (options.categories) landmark.category = j % 3 == 0 ? "tree" : "pole";
    if (options.uncertain_map) landmark.stddev = {random.uniform(0, 0.3), random.uniform(0, 0.3)};
    landmarks.push_back(landmark);
  }
  return LandmarkTable(landmarks);
}

Reading readingOf(const Options& options)
{
  Reading reading;
  reading.sensor = "camera";
  reading.model.clutter_probability = options.clutter;
  if (options.offset) reading.T_robot_sensor = {0.4, -0.2, 2.5};
  if (options.sensor_covariance) reading.sensor_position_covariance << 0.04, 0.01, 0.01, 0.02;
  if (options.slant) reading.sensor_height = 1.5;
  if (options.field_of_view) reading.model.has_field_of_view = true;
  if (options.field_of_view) reading.model.field_of_view = degToRad(100);
  if (options.max_range) reading.model.max_range = 15;
  if (options.missed)
  {
    reading.model.detection_probability = 0.8;
    reading.model.has_field_of_view = true;
  }
  return reading;
}

Detection detectionOf(const Options& options, const Scene& scene, const Pose2& truth, std::size_t j,
                      RandomStream& random)
{
  const LandmarkPrediction prediction = predict(scene.map[j], scene.reading, truth);
  const Landmark& landmark = scene.map[j];
  Detection detection{.id = options.identified ? landmark.id : kNoId, .category = landmark.category};
  if (options.unknown_ids && random.chance(0.3)) detection.id = 100000;
  if (options.bearing) detection.bearing = wrap(prediction.bearing + options.std_bearing * random.gaussian());
  if (options.range) detection.range = std::max(0.1, prediction.range + options.std_range * random.gaussian());
  detection.std_bearing = options.bearing ? options.std_bearing * random.uniform(0.8, 1.2) : 0;
  detection.std_range = options.range ? options.std_range * random.uniform(0.8, 1.2) : 0;
  return detection;
}

Scene sceneOf(const Options& options, std::uint64_t seed)
{
  RandomStream random(seed);
  Scene scene;
  scene.map = mapOf(options, random);
  if (options.own_clutter)
    for (std::size_t j = 0; j < scene.map.size(); ++j) scene.clutter.push_back(random.uniform(0.01, 0.9));
  scene.reading = readingOf(options);
  const Pose2 truth{kOrigin.x() + random.uniform(-5, 5), kOrigin.y() + random.uniform(-5, 5), random.uniform(-3, 3)};
  for (int d = 0; d < 7; ++d)
    scene.reading.detections.push_back(detectionOf(options, scene, truth, random.below(scene.map.size()), random));
  for (std::size_t i = 0; i < kRobots; ++i)
    scene.robots.add({truth.x + options.spread * random.gaussian(), truth.y + options.spread * random.gaussian(),
                      wrap(truth.phi + 0.1 * options.spread * random.gaussian())});
  if (options.biased)
  {
    scene.bias_states = {{.kind = BiasKind::bearing_offset, .sensor = "camera"},
                         {.kind = BiasKind::range_offset, .sensor = "another"},
                         {.kind = BiasKind::range_scale, .sensor = ""},
                         {.kind = BiasKind::distance_scale},
                         {.kind = BiasKind::range_offset, .sensor = "camera"}};
    for (std::size_t k = 0; k < scene.bias_states.size(); ++k)
    {
      scene.bias.emplace_back();
      for (std::size_t i = 0; i < kRobots; ++i)
        scene.bias.back().push_back(static_cast<float>(0.03 * random.gaussian()));
    }
  }
  return scene;
}

class EveryOption : public ::testing::TestWithParam<Options>
{
};

std::vector<Options> allOptions()
{
  std::vector<Options> all;
  for (const bool identified : {true, false})
    for (const int measures : {1, 2, 3})
    {
      Options plain{.bearing = (measures & 1) != 0, .range = (measures & 2) != 0, .identified = identified};
      const auto with = [&](const std::string& name, const auto& change)
      {
        Options changed = plain;
        change(changed);
        changed.name = std::string(identified ? "Identified" : "Anonymous") + (plain.bearing ? "Bearing" : "") +
                       (plain.range ? "Range" : "") + name;
        all.push_back(changed);
      };
      with("Plain", [](Options&) {});
      with("Offset", [](Options& o) { o.offset = true; });
      with("Carried", [](Options& o) { o.sensor_covariance = o.offset = true; });
      with("Slant", [](Options& o) { o.slant = true; });
      with("UncertainMap", [](Options& o) { o.uncertain_map = true; });
      with("OwnClutter", [](Options& o) { o.own_clutter = true; });
      with("NoClutter", [](Options& o) { o.clutter = 0; });
      with("OnlyClutter", [](Options& o) { o.clutter = 1; });
      with("Wide",
           [](Options& o)
           {
             o.std_bearing = 0.5;
             o.std_range = 3;
           });
      with("Sharp",
           [](Options& o)
           {
             o.std_bearing = 2e-3;
             o.std_range = 0.01;
             o.spread = 0.02;
           });
      with("View", [](Options& o) { o.field_of_view = o.max_range = true; });
      with("Missed", [](Options& o) { o.field_of_view = o.max_range = o.missed = true; });
      with("MissedAllRound", [](Options& o) { o.max_range = o.missed = true; });
      with("Biased", [](Options& o) { o.biased = o.max_range = true; });
      with("Spread",
           [](Options& o)
           {
             o.spread = 8;
             o.field_of_view = o.max_range = o.missed = true;
           });
      with("ManyLandmarks",
           [](Options& o)
           {
             o.landmarks = 400;
             o.spread = 0.05;
             o.range = o.bearing && o.range;
           });
      with("UnknownIds", [](Options& o) { o.unknown_ids = true; });
      with("Categories", [](Options& o) { o.categories = o.max_range = true; });
      with("Everything",
           [](Options& o)
           {
             o.offset = o.sensor_covariance = o.slant = o.uncertain_map = o.own_clutter = o.field_of_view =
                 o.max_range = o.missed = o.biased = o.categories = o.unknown_ids = true;
           });
    }
  return all;
}
}  // namespace

TEST_P(EveryOption, ScoresLikeTheDoublePrecisionLikelihood)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const Scene scene = sceneOf(GetParam(), seed);
    const PoseBatch robots = scene.batch();
    std::vector<float> found(kRobots, 0.5F);
    addLogLikelihood(scene.reading, scene.map, scene.clutter, robots, found);
    for (std::size_t i = 0; i < kRobots; i += 7)
    {
      const double expected = logLikelihood(scene.reading, scene.map, robots[i], scene.clutter,
                                            sensorBias(robots, i, scene.reading.sensor));
      // What single precision does to a sharp detection: 3e-7 rad and 2e-6 m, felt at up to 6 standard deviations.
      const double rounding = 7 * 6 *
                              std::max(GetParam().bearing ? 3e-7 / GetParam().std_bearing : 0.0,
                                       GetParam().range ? 4e-6 / GetParam().std_range : 0.0);
      const double tolerance = 1e-4 + rounding + (GetParam().identified ? 0 : 7 * 2e-4);
      ASSERT_NEAR(double{found[i]} - 0.5, expected, tolerance) << "seed " << seed << ", robot " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ReadingScorer, EveryOption, ::testing::ValuesIn(allOptions()),
                         [](const auto& option) { return option.param.name; });

TEST(ReadingScorer, SharesItsWorkBetweenBatches)
{
  const Scene scene = sceneOf({.range = true, .identified = false}, 9);
  const PoseBatch robots = scene.batch();
  const ReadingScorer scorer(scene.reading, scene.map, scene.clutter, kOrigin);
  std::vector<float> whole(kRobots, 0.0F), parts(kRobots, 0.0F);
  scorer.addTo(robots, whole);
  for (std::size_t first = 0; first < kRobots; first += 100)
    scorer.addTo(robots.block(first, 100), std::span(parts).subspan(first, 100));
  for (std::size_t i = 0; i < kRobots; ++i) EXPECT_NEAR(whole[i], parts[i], 7 * 2e-4);
}

TEST(ReadingScorer, NoRobotsNoDetectionsNoMap)
{
  const Scene scene = sceneOf({}, 10);
  addLogLikelihood(scene.reading, scene.map, {}, {}, {});
  std::vector<float> out(kRobots, 0.0F);
  addLogLikelihood({}, scene.map, {}, scene.batch(), out);
  EXPECT_EQ(out, std::vector<float>(kRobots, 0.0F));
  Scene anonymous = sceneOf({.identified = false}, 11);
  addLogLikelihood(anonymous.reading, {}, {}, anonymous.batch(), out);
  for (const float value : out) EXPECT_NEAR(value, -7 * std::log(kTwoPi), 1e-5);
}

TEST(ReadingScorer, StaysFiniteWhereverTheRobotIs)
{
  const Scene scene = sceneOf({.range = true, .std_bearing = 1e-4, .std_range = 1e-3, .clutter = 0}, 12);
  PoseColumns robots(kOrigin);
  for (const Vector3d& at : {Vector3d(1e9, -1e9, 2), Vector3d(-1e15, 0, 0), scene.map[0].position})
    robots.add({at.x(), at.y(), 1});
  std::vector<float> out(3, 0.0F);
  addLogLikelihood(scene.reading, scene.map, {}, robots.batch(), out);
  for (const float value : out) EXPECT_TRUE(std::isfinite(value));
}
}  // namespace mrpt_ext::test_reading_scorer
