#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>

#include "cramer_rao_trials.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kScenes = 256;  // taken in turn, so that no branch is learned by heart

struct Sample
{
  Pose2 truth;
  std::vector<PoseMeasurement> measurements;
};

std::vector<Sample> samples(MeasurementSetup::What what)
{
  RandomStream random(31);
  std::vector<Sample> result;
  for (std::size_t k = 0; k < kScenes; ++k)
  {
    const Scene scene = randomScene(random, 10);
    result.push_back({scene.robot, measureScene(scene, {what, degToRad(0.3), 0.05}, random)});
  }
  return result;
}

/// Gauss-Newton as in a textbook: five steps from the true pose.
Pose2 gaussNewton(const std::vector<PoseMeasurement>& measurements, Pose2 pose)
{
  for (int k = 0; k < 5; ++k)
  {
    Matrix3d hessian = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    for (const PoseMeasurement& m : measurements)
    {
      const JacobianRow row = jacobian(m, pose) / m.std;
      hessian += row.transpose() * row;
      gradient += row.transpose() * (residual(m, pose) / m.std);
    }
    const Vector3d step = hessian.ldlt().solve(gradient);
    pose = {pose.x - step.x(), pose.y - step.y(), wrap(pose.phi - step.z())};
  }
  return pose;
}

void ours(benchmark::State& state, MeasurementSetup::What what)
{
  const std::vector<Sample> all = samples(what);
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(solvePoseFromLandmarks(all[k++ % kScenes].measurements));
}

void plain(benchmark::State& state, MeasurementSetup::What what)
{
  const std::vector<Sample> all = samples(what);
  std::size_t k = 0;
  for (auto _ : state)
  {
    const Sample& sample = all[k++ % kScenes];
    benchmark::DoNotOptimize(gaussNewton(sample.measurements, sample.truth));
  }
}

BENCHMARK_CAPTURE(ours, bearings, MeasurementSetup::What::bearings)->Name("refine/ten_bearings/ours");
BENCHMARK_CAPTURE(plain, bearings, MeasurementSetup::What::bearings)->Name("refine/ten_bearings/plain");
BENCHMARK_CAPTURE(ours, ranges, MeasurementSetup::What::ranges)->Name("refine/ten_ranges/ours");
BENCHMARK_CAPTURE(ours, mixed, MeasurementSetup::What::mixed)->Name("refine/ten_mixed/ours");
BENCHMARK_CAPTURE(plain, mixed, MeasurementSetup::What::mixed)->Name("refine/ten_mixed/plain");
}  // namespace
}  // namespace mrpt_ext
