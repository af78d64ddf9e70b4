#include <algorithm>
#include <ctime>
#include <functional>
#include <iomanip>
#include <memory>

#include "filter_scenario.h"
#include "mrpt_ext/experiment/mrpt_filter_localizer.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/localizers/kalman_localizer.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"
#include "random_frames.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kFrames = 8;  // the window of the first ones, then the trajectory
constexpr double kSeedWindow = 3;   // [s]

/// [s] of this thread.
double threadTime()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Steps
{
  std::vector<double> seconds;
  std::string slowest;

  void add(double time, const RandomFrames& scene, std::size_t step)
  {
    if (seconds.empty() || time > *std::max_element(seconds.begin(), seconds.end()))
      slowest = scene.text() + ", step " + std::to_string(step);
    seconds.push_back(time);
  }
};

struct Method
{
  std::string name;
  std::function<std::unique_ptr<Localizer>(const RandomFrames&)> make;
};

ParticleFilterOptions filterOptions(const RandomFrames& scene)
{
  ParticleFilterOptions options;
  options.region = scene.region;
  options.motion = {.std_xy_per_m = 0.05, .std_phi_per_deg = 0.05};
  return options;
}

Method kalmanMethod(const std::string& name, bool iterated, std::size_t hypotheses)
{
  return {name, [=](const RandomFrames& scene)
          {
            const ParticleFilterOptions like = filterOptions(scene);
            const KalmanBankOptions options{.max_hypotheses = hypotheses, .iterated = iterated, .motion = like.motion};
            return std::make_unique<KalmanLocalizer>(name, options, scene.map, like.region, kSeedWindow,
                                                     std::make_shared<const GlobalPoseSearch>(scene.map));
          }};
}

std::vector<Method> methods()
{
  return {{"particle_filter", [](const RandomFrames& scene)
           { return std::make_unique<ParticleFilterLocalizer>(filterOptions(scene), scene.map, kSeedWindow, 1); }},
          {"particle_filter, engine of MRPT",
           [](const RandomFrames& scene)
           {
             LocalizationConfig config;
             config.filter = filterOptions(scene);
             return makeMrptFilterLocalizer(config, scene.map, 1, 0);
           }},
          kalmanMethod("extended_kalman_filter", false, 1),
          kalmanMethod("iterated_kalman_filter", true, 1),
          kalmanMethod("kalman_filter_bank", false, KalmanBankOptions{}.max_hypotheses)};
}

/// Largest numbers.
struct Row
{
  int landmarks, detections;
};

Steps measure(const Method& method, const Row& row)
{
  Steps steps;
  RandomStream random(11, static_cast<std::uint64_t>(row.landmarks + row.detections));
  for (int trial = 0; trial < studyRuns(60); ++trial)
  {
    const RandomFrames scene = randomFrames(row.landmarks, row.detections, kFrames, random);
    const std::unique_ptr<Localizer> localizer = method.make(scene);
    for (std::size_t k = 0; k < scene.frames.size(); ++k)
    {
      const double before = threadTime();
      (void)localizer->process(scene.frames[k]);
      steps.add(threadTime() - before, scene, k);
    }
  }
  std::sort(steps.seconds.begin(), steps.seconds.end());
  return steps;
}

void tabulate(std::ostream& out)
{
  out << "| method | landmarks up to | detections up to | steps | median | 90 % | slowest | which "
         "|\n|---|---|---|---|---|---|---|---|\n";
  for (const Method& method : methods())
    for (const Row& row : {Row{40, 50}, Row{1000, 50}, Row{10'000, 50}, Row{1000, 5000}, Row{10'000, 5000}})
    {
      const Steps steps = measure(method, row);
      const auto at = [&](double share)
      { return steps.seconds[static_cast<std::size_t>(share * static_cast<double>(steps.seconds.size() - 1))]; };
      out << std::setprecision(3) << "| " << method.name << " | " << row.landmarks << " | " << row.detections << " | "
          << steps.seconds.size() << " | " << 1e3 * at(0.5) << " ms | " << 1e3 * at(0.9) << " ms | " << 1e3 * at(1)
          << " ms | " << steps.slowest << " |" << std::endl;
    }
}

const RegisterStudy kRandomFrames("random_frames",
                                  "Frames of any size in any map, right or wrong: how long does a step take?",
                                  tabulate);
}  // namespace
}  // namespace mrpt_ext
