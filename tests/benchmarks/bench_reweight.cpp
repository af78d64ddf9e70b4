#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "limit/limit_reweight.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

// Ten bearings of 0.02 rad scored for 10 000 robots within some 5 cm, landmarks all over a square of 100 m.
namespace mrpt_ext
{
namespace
{
constexpr std::size_t kRobots = 10000;
constexpr int kBearings = 10;
constexpr double kSide = 100, kStd = 0.02;
const Vector2d kMiddle(kSide / 2, kSide / 2);

/// A column on a 64-byte boundary.
struct Column
{
  struct alignas(64) Lanes
  {
    float values[16];
  };
  std::vector<Lanes> lanes = std::vector<Lanes>((kRobots + 15) / 16);
  float* data() { return lanes.front().values; }
};

struct Scene
{
  LandmarkTable map;
  Reading reading;
  ParticleSet robots{kMiddle};
};

Scene sceneOf(std::size_t landmarks, bool named)
{
  RandomStream random(1);
  std::vector<Landmark> table;
  for (std::size_t j = 0; j < landmarks; ++j)
    table.push_back({.id = static_cast<int>(j), .position = {random.uniform(0, kSide), random.uniform(0, kSide), 0.0}});
  Scene scene{.map = LandmarkTable(table)};
  scene.reading.sensor = "camera";
  for (int k = 0; k < kBearings; ++k)
  {
    const Landmark& seen = table[static_cast<std::size_t>(k) * landmarks / kBearings];
    const Vector2d d = seen.position.head<2>() - kMiddle;
    const double bearing = wrap(std::atan2(d.y(), d.x()) - 0.3 + kStd * random.gaussian());
    scene.reading.detections.push_back({.id = named ? seen.id : kNoId, .bearing = bearing, .std_bearing = kStd});
  }
  for (std::size_t i = 0; i < kRobots; ++i)
    scene.robots.add({kMiddle.x() + 0.05 * random.gaussian(), kMiddle.y() + 0.05 * random.gaussian(),
                      0.3 + 0.005 * random.gaussian()},
                     0);
  return scene;
}

void reportPerRobot(benchmark::State& state)
{
  state.counters["ns_per_particle"] =
      benchmark::Counter(1e-9 * kRobots, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// What the library gives its users: mixture with clutter, everything that depends on the reading prepared anew.
void ours(benchmark::State& state, std::size_t landmarks, bool named)
{
  Scene scene = sceneOf(landmarks, named);
  for (auto _ : state)
  {
    addLogLikelihood(scene.reading, scene.map, {}, scene.robots.poses(), scene.robots.log_weight);
    benchmark::DoNotOptimize(scene.robots.log_weight.data());
    benchmark::ClobberMemory();
  }
  reportPerRobot(state);
}

void limitForm(benchmark::State& state, std::size_t landmarks, bool named)
{
  if (!limit::canReweight()) return state.SkipWithError("needs AVX-512");
  Scene scene = sceneOf(landmarks, true);
  std::array<Column, 5> columns;
  for (std::size_t i = 0; i < kRobots; ++i)
  {
    columns[0].data()[i] = scene.robots.x[i];
    columns[1].data()[i] = scene.robots.y[i];
    columns[2].data()[i] = std::cos(scene.robots.phi[i]);
    columns[3].data()[i] = std::sin(scene.robots.phi[i]);
  }
  std::vector<limit::Bearing> bearings;
  for (const Detection& d : scene.reading.detections)
  {
    const Vector2d at = scene.map[static_cast<std::size_t>(d.id)].position.head<2>() - kMiddle;
    bearings.push_back({static_cast<float>(std::cos(*d.bearing)), static_cast<float>(std::sin(*d.bearing)),
                        static_cast<float>(at.x()), static_cast<float>(at.y())});
  }
  std::vector<float> x, y;
  for (const Landmark& landmark : scene.map.all())
  {
    x.push_back(static_cast<float>(landmark.position.x() - kMiddle.x()));
    y.push_back(static_cast<float>(landmark.position.y() - kMiddle.y()));
  }
  const limit::Robots robots{columns[0].data(), columns[1].data(), columns[2].data(),
                             columns[3].data(), columns[4].data(), kRobots};
  const float kappa = 1 / (kStd * kStd);
  for (auto _ : state)
  {
    if (named)
      limit::reweightKnown(robots, bearings.data(), kBearings, kappa);
    else
      limit::reweightNearest(robots, bearings.data(), x.data(), y.data(), static_cast<int>(x.size()), kappa);
    benchmark::DoNotOptimize(robots.log_weight);
    benchmark::ClobberMemory();
  }
  reportPerRobot(state);
}

/// What one would write down first: double precision, one robot after the other.
void plain(benchmark::State& state, std::size_t landmarks)
{
  const Scene scene = sceneOf(landmarks, true);
  std::vector<Pose2> robots;
  for (std::size_t i = 0; i < kRobots; ++i) robots.push_back(scene.robots.pose(i));
  std::vector<double> weight(kRobots, 1.0);
  for (auto _ : state)
  {
    for (std::size_t i = 0; i < kRobots; ++i)
    {
      double likelihood = 1;
      for (const Detection& d : scene.reading.detections)
      {
        const Landmark& landmark = scene.map[static_cast<std::size_t>(d.id)];
        const double dx = landmark.position.x() - robots[i].x, dy = landmark.position.y() - robots[i].y;
        const double error = wrap(std::atan2(dy, dx) - robots[i].phi - *d.bearing);
        likelihood *= 0.95 * std::exp(-0.5 * square(error / kStd)) / (kStd * std::sqrt(kTwoPi)) + 0.05 / kTwoPi;
      }
      weight[i] = likelihood;
    }
    benchmark::DoNotOptimize(weight.data());
    benchmark::ClobberMemory();
  }
  reportPerRobot(state);
}

BENCHMARK_CAPTURE(ours, known_10, 10, true)->Name("reweight/known_10_landmarks/ours");
BENCHMARK_CAPTURE(limitForm, known_10, 10, true)->Name("reweight/known_10_landmarks/limit");
BENCHMARK_CAPTURE(plain, known_10, 10)->Name("reweight/known_10_landmarks/plain");
BENCHMARK_CAPTURE(ours, known_1000, 1000, true)->Name("reweight/known_1000_landmarks/ours");
BENCHMARK_CAPTURE(limitForm, known_1000, 1000, true)->Name("reweight/known_1000_landmarks/limit");
BENCHMARK_CAPTURE(ours, anonymous_1000, 1000, false)->Name("reweight/anonymous_1000_landmarks/ours");
BENCHMARK_CAPTURE(limitForm, anonymous_1000, 1000, false)->Name("reweight/anonymous_1000_landmarks/limit");
}  // namespace
}  // namespace mrpt_ext
