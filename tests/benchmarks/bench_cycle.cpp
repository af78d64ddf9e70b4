#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "allocation_peak.h"
#include "mrpt_ext/experiment/mrpt_filter_localizer.h"
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"

// The whole cycle of the particle filter, frame after frame, as the application runs it: odometry, ten identified
// bearings of 1 degree with clutter, modes, agreement of the landmarks, verdict, resampling when it is due. The robot
// goes round in a hall of 30 m.
namespace mrpt_ext
{
namespace
{
constexpr std::size_t kParticles = 100000;
constexpr double kSide = 30;
constexpr int kFrames = 40;

struct Drive
{
  LandmarkTable map;
  Pose2 start{15, 8, 0};
  std::vector<Frame> frames;
};

Drive driveRound()
{
  RandomStream random(1);
  Drive drive;
  std::vector<Landmark> landmarks;
  for (int j = 0; j < 10; ++j)
    landmarks.push_back({.id = j, .position = {random.uniform(0, kSide), random.uniform(0, kSide), 0.0}});
  drive.map = LandmarkTable(landmarks);
  const Pose2 step{0.1, 0, 0.1 / 7};
  Pose2 truth = drive.start;
  for (int k = 0; k < kFrames; ++k)
  {
    truth = compose(truth, step);
    Frame frame{.time = 0.1 * k};
    frame.motion = {
        {step.x + 0.005 * random.gaussian(), 0.005 * random.gaussian(), step.phi + 0.004 * random.gaussian()},
        0.1,
        step.phi,
        0.1};
    Reading reading{.time = frame.time, .sensor = "camera", .T_robot_sensor = {0.2, 0, 0}};
    for (const Landmark& landmark : drive.map.all())
    {
      const double bearing = predictBearing(truth, landmark.position.head<2>(), reading.T_robot_sensor);
      const double std = degToRad(1);
      reading.detections.push_back(
          {.id = landmark.id, .bearing = wrap(bearing + std * random.gaussian()), .std_bearing = std});
    }
    frame.readings.push_back(std::move(reading));
    drive.frames.push_back(std::move(frame));
  }
  return drive;
}

ParticleFilterOptions optionsFor(const Drive& drive, std::size_t particles)
{
  ParticleFilterOptions options;
  options.particles = options.initial_particles = particles;
  options.region = {{0, 0}, {kSide, kSide}};
  options.initial_mode = InitialMode::gaussian;
  options.initial_pose = {drive.start, Vector3d(0.04, 0.04, 0.0025).asDiagonal()};
  return options;
}

void reportPerParticle(benchmark::State& state, std::size_t particles)
{
  state.counters["ns_per_particle"] =
      benchmark::Counter(1e-9 * static_cast<double>(particles),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void ours(benchmark::State& state, unsigned threads)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const Drive drive = driveRound();
  ParticleFilterOptions options = optionsFor(drive, kParticles);
  options.threads = threads;
  std::optional<ParticleFilter> filter;
  const std::size_t without = allocatedBytes();
  startPeak();
  std::size_t k = drive.frames.size();
  for (auto _ : state)
  {
    if (k == drive.frames.size())
    {
      state.PauseTiming();
      filter.reset();
      filter.emplace(options, drive.map, 1, 0);
      filter->process(drive.frames[0], {});
      k = 1;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(filter->process(drive.frames[k++], {}).effective_ratio);
  }
  state.counters["bytes_per_particle"] = static_cast<double>(peakBytes() - without) / kParticles;
  const auto estimate = filter->process({}, {}).modes.modes.front().pose.mean;
  Pose2 truth = drive.start;
  for (std::size_t i = 0; i < k; ++i) truth = compose(truth, {0.1, 0, 0.1 / 7});
  state.counters["error_m"] = (estimate.position() - truth.position()).norm();
  reportPerParticle(state, kParticles);
}

/// MRPT's own filter over the same map and frames.
void mrptFilter(benchmark::State& state)
{
  constexpr std::size_t kFewer = kParticles / 10;  // its time grows with the number, and so does the waiting
  const Drive drive = driveRound();
  LocalizationConfig config;
  config.filter = optionsFor(drive, kFewer);
  const auto filter = makeMrptFilterLocalizer(config, drive.map, 1, 0);
  (void)filter->process(drive.frames[0]);
  std::size_t k = 1;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(filter->process(drive.frames[k]).ambiguous);
    k = 1 + k % (drive.frames.size() - 1);
  }
  reportPerParticle(state, kFewer);
}

BENCHMARK_CAPTURE(ours, one_thread, 1)->Name("cycle/100k/ours")->Unit(benchmark::kMillisecond);
BENCHMARK(mrptFilter)->Name("cycle/100k/mrpt")->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK_CAPTURE(ours, two_threads, 2)
    ->Name("cycle/100k_two_threads/ours")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}  // namespace
}  // namespace mrpt_ext
