#include "limit/limit_three_bearings.h"
#include "mrpt_ext/solvers/three_bearing_pose.h"
#include "sighted_scenes.h"
#include "three_bearing_pose_batch.h"

namespace mrpt_ext
{
namespace
{
/// Landmarks, then unit vectors, as the numbers of one problem lie side by side; and the bearings.
struct Problem
{
  double at[6], u[6], bearing[3];
};

std::vector<Problem> threeBearingProblems()
{
  std::vector<Problem> problems(kProblems);
  const std::vector<SightedScene> scenes = sightedScenes(3);
  for (std::size_t m = 0; m < kProblems; ++m)
    for (std::size_t i = 0; i < 3; ++i)
    {
      problems[m].at[2 * i] = scenes[m].scene.landmarks[i].x();
      problems[m].at[2 * i + 1] = scenes[m].scene.landmarks[i].y();
      problems[m].u[2 * i] = scenes[m].units[i].x();
      problems[m].u[2 * i + 1] = scenes[m].units[i].y();
      problems[m].bearing[i] = scenes[m].bearings[i];
    }
  return problems;
}

/// Sums up the answers of `solve`, so that none is left out by the compiler.
template <class Solve>
void overProblems(benchmark::State& state, const Solve& solve)
{
  const std::vector<Problem> problems = threeBearingProblems();
  for (auto _ : state)
  {
    double sum = 0;
    for (const Problem& p : problems) sum += solve(p);
    benchmark::DoNotOptimize(sum);
  }
  reportPerItem(state, kProblems);
}

/// Landmarks and unit vectors without gaps, the same for ours and the limit.
struct PackedProblems
{
  std::vector<double> at, u;

  PackedProblems()
  {
    for (const Problem& p : threeBearingProblems())
    {
      at.insert(at.end(), p.at, p.at + 6);
      u.insert(u.end(), p.u, p.u + 6);
    }
  }
  [[nodiscard]] VisibleLandmark<double> sight(std::size_t m, std::size_t i) const
  {
    const std::size_t k = 6 * m + 2 * i;
    return {at[k], at[k + 1], u[k], u[k + 1]};
  }
};

/// Place and validity, with the heading on request.
template <bool kHeading>
void scalarOurs(benchmark::State& state)
{
  const PackedProblems problems;
  for (auto _ : state)
  {
    double sum = 0;
    for (std::size_t m = 0; m < kProblems; ++m)
    {
      const auto pose = solveThreeBearingPose(problems.sight(m, 0), problems.sight(m, 1), problems.sight(m, 2));
      if (pose.outcome == ThreeBearingOutcome::pose) sum += pose.x + pose.y + (kHeading ? pose.c + pose.s : 0);
    }
    benchmark::DoNotOptimize(sum);
  }
  reportPerItem(state, kProblems);
}

void scalarLimit(benchmark::State& state)
{
  const PackedProblems problems;
  for (auto _ : state)
    benchmark::DoNotOptimize(limit::sumOfTotalPositions(problems.at.data(), problems.u.data(), kProblems));
  reportPerItem(state, kProblems);
}

/// ToTal as published: bearings as angles, cotangents by division, heading from the first landmark.
double totalFromAngles(const Problem& p)
{
  const double x1 = p.at[0] - p.at[2], y1 = p.at[1] - p.at[3], x3 = p.at[4] - p.at[2], y3 = p.at[5] - p.at[3];
  const double cot12 = 1 / std::tan(p.bearing[1] - p.bearing[0]), cot23 = 1 / std::tan(p.bearing[2] - p.bearing[1]);
  const double cot31 = (1 - cot12 * cot23) / (cot12 + cot23);
  const double x12 = x1 + cot12 * y1, y12 = y1 - cot12 * x1, x23 = x3 - cot23 * y3, y23 = y3 + cot23 * x3;
  const double x31 = x3 + x1 + cot31 * (y3 - y1), y31 = y3 + y1 - cot31 * (x3 - x1);
  const double k31 = x1 * x3 + y1 * y3 + cot31 * (x1 * y3 - x3 * y1);
  const double factor = k31 / ((x12 - x23) * (y23 - y31) - (y12 - y23) * (x23 - x31));
  const double x = p.at[2] + factor * (y12 - y23), y = p.at[3] + factor * (x23 - x12);
  return x + y + std::atan2(p.at[1] - y, p.at[0] - x) - p.bearing[0];
}

void scalarPlain(benchmark::State& state) { overProblems(state, totalFromAngles); }

/// An array per quantity, in the order of Problem.
template <class Real>
struct ProblemArrays
{
  std::vector<Real> in[12], x, y, c, s, valid;

  ProblemArrays() : x(kProblems), y(kProblems), c(kProblems), s(kProblems), valid(kProblems)
  {
    for (const Problem& p : threeBearingProblems())
      for (int k = 0; k < 12; ++k) in[k].push_back(static_cast<Real>(k < 6 ? p.at[k] : p.u[k - 6]));
  }
};

/// Position and validity; with headings on request.
template <class Real, bool kHeadings>
void batchOurs(benchmark::State& state)
{
  ProblemArrays<Real> a;
  ThreeBearingArrays<Real> problems;
  for (std::size_t i = 0; i < 3; ++i)
  {
    problems.x[i] = a.in[2 * i].data();
    problems.y[i] = a.in[2 * i + 1].data();
    problems.c[i] = a.in[6 + 2 * i].data();
    problems.s[i] = a.in[7 + 2 * i].data();
  }
  problems.count = kProblems;
  for (auto _ : state)
  {
    const PositionArrays<Real> positions{a.x.data(), a.y.data(), a.valid.data()};
    if constexpr (kHeadings)
      posesFromThreeBearings(problems, positions, {a.c.data(), a.s.data()});
    else
      positionsFromThreeBearings(problems, positions);
    benchmark::ClobberMemory();
  }
  reportPerItem(state, kProblems);
}

template <class Real>
void batchLimit(benchmark::State& state)
{
  ProblemArrays<Real> a;
  const Real* in[12];
  for (int k = 0; k < 12; ++k) in[k] = a.in[k].data();
  for (auto _ : state)
  {
    limit::totalPositions(in, kProblems, a.x.data(), a.y.data());
    benchmark::ClobberMemory();
  }
  reportPerItem(state, kProblems);
}

BENCHMARK(scalarOurs<false>)->Name("hypothesis/three_bearings/ours");
BENCHMARK(scalarOurs<true>)->Name("hypothesis/three_bearings/ours_with_heading");
BENCHMARK(scalarLimit)->Name("hypothesis/three_bearings/limit");
BENCHMARK(scalarPlain)->Name("hypothesis/three_bearings/plain");
BENCHMARK(batchOurs<double, false>)->Name("hypothesis/three_bearings_batch/ours");
BENCHMARK(batchOurs<double, true>)->Name("hypothesis/three_bearings_batch/ours_with_heading");
BENCHMARK(batchLimit<double>)->Name("hypothesis/three_bearings_batch/limit");
BENCHMARK(batchOurs<float, false>)->Name("hypothesis/three_bearings_batch_f32/ours");
BENCHMARK(batchOurs<float, true>)->Name("hypothesis/three_bearings_batch_f32/ours_with_heading");
BENCHMARK(batchLimit<float>)->Name("hypothesis/three_bearings_batch_f32/limit");
}  // namespace
}  // namespace mrpt_ext
