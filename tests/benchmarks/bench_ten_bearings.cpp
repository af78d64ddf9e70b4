#include <array>
#include <complex>

#include "limit/limit_ten_bearings.h"
#include "mrpt_ext/solvers/bearing_pose_from_units.h"
#include "sighted_scenes.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kBearings = 10;
using Complex = std::complex<double>;

struct Problem
{
  std::array<UnitBearing, kBearings> sights;
  std::array<double, kBearings> bearings;
};

std::vector<Problem> tenBearingProblems()
{
  std::vector<Problem> problems(kProblems);
  const std::vector<SightedScene> scenes = sightedScenes(static_cast<int>(kBearings));
  for (std::size_t m = 0; m < kProblems; ++m)
    for (std::size_t i = 0; i < kBearings; ++i)
    {
      problems[m].sights[i] = {scenes[m].scene.landmarks[i], scenes[m].units[i]};
      problems[m].bearings[i] = scenes[m].bearings[i];
    }
  return problems;
}

template <class Solve>
void overProblems(benchmark::State& state, const Solve& solve)
{
  const std::vector<Problem> problems = tenBearingProblems();
  for (auto _ : state)
  {
    double sum = 0;
    for (const Problem& p : problems) sum += solve(p);
    benchmark::DoNotOptimize(sum);
  }
  reportPerItem(state, kProblems);
}

double solveOurs(const Problem& p)
{
  const BearingPoseFromUnits pose = solveBearingPoseFromUnits(p.sights);
  return pose.status == SolveStatus::ok ? pose.position.sum() + pose.heading.sum() + pose.det_ratio : 0;
}

/// Betke, Gurvits (IEEE T-RA 13(2), 1997): one unknown distance ratio per landmark, their n x n system solved in O(n)
/// by two rank-one updates, and the mean of the positions that the ratios give. Reference: the last landmark.
double solvePlain(const Problem& p)
{
  constexpr std::size_t n = kBearings - 1;
  const auto point = [&](std::size_t i) { return Complex(p.sights[i].landmark.x(), p.sights[i].landmark.y()); };
  std::array<Complex, n> b, c;
  Complex sum_c = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    c[i] = 1.0 / (point(i) - point(n));
    b[i] = c[i] * std::polar(1.0, p.bearings[i] - p.bearings[n]);
    sum_c += c[i];
  }
  const auto dot = [](Complex u, Complex v) { return u.real() * v.real() + u.imag() * v.imag(); };
  // (diag(n |b|^2) - Re b Re b^T - Im b Im b^T) r = s
  std::array<double, n> s, weight, inner_s, inner_b;
  double xs = 0, xy = 0, xx = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    s[i] = static_cast<double>(n) * dot(b[i], c[i]) - dot(b[i], sum_c);
    weight[i] = 1 / (static_cast<double>(n) * std::norm(b[i]));
    xs += weight[i] * b[i].real() * s[i];
    xy += weight[i] * b[i].real() * b[i].imag();
    xx += weight[i] * b[i].real() * b[i].real();
  }
  double ys = 0, yy = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    inner_s[i] = weight[i] * (s[i] + b[i].real() * xs / (1 - xx));
    inner_b[i] = weight[i] * (b[i].imag() + b[i].real() * xy / (1 - xx));
    ys += b[i].imag() * inner_s[i];
    yy += b[i].imag() * inner_b[i];
  }
  Complex robot = 0;
  for (std::size_t i = 0; i < n; ++i)
    robot += point(n) - 1.0 / ((inner_s[i] + inner_b[i] * ys / (1 - yy)) * b[i] - c[i]);
  robot /= static_cast<double>(n);
  return robot.real() + robot.imag() + std::arg(point(n) - robot) - p.bearings[n];
}

void ours(benchmark::State& state) { overProblems(state, solveOurs); }
void limitForm(benchmark::State& state)
{
  std::vector<double> landmarks, units;
  for (const Problem& p : tenBearingProblems())
    for (const UnitBearing& sight : p.sights)
    {
      landmarks.insert(landmarks.end(), {sight.landmark.x(), sight.landmark.y()});
      units.insert(units.end(), {sight.unit.x(), sight.unit.y()});
    }
  for (auto _ : state)
    benchmark::DoNotOptimize(limit::sumOfLinearPositions(landmarks.data(), units.data(), kBearings, kProblems));
  reportPerItem(state, kProblems);
}
void plain(benchmark::State& state) { overProblems(state, solvePlain); }

BENCHMARK(ours)->Name("hypothesis/ten_bearings/ours");
BENCHMARK(limitForm)->Name("hypothesis/ten_bearings/limit");
BENCHMARK(plain)->Name("hypothesis/ten_bearings/plain");
}  // namespace
}  // namespace mrpt_ext
