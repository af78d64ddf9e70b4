#include "fix_study.h"

#include "error_at_bound.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "paper_settings.h"
#include "running_fix_trial.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr double kNoBound = 1e3;  // [m] stands for a place that the measurements leave open

FixScene randomScene(const Settings& settings, double way, RandomStream& random)
{
  const std::string s = "Study";
  const double range = random.uniform(settings.number(s, "min_range_m"), settings.number(s, "max_range_m"));
  const double side = random.uniform(-kPi, kPi), direction = random.uniform(-kPi, kPi);
  FixScene scene;
  scene.second = {range * std::cos(side), range * std::sin(side), random.uniform(-kPi, kPi)};
  scene.first = {scene.second.x - way * std::cos(direction), scene.second.y - way * std::sin(direction),
                 scene.second.phi};
  return scene;
}

double drawnError(const std::optional<Matrix2d>& bound, RandomStream& random)
{
  return bound ? errorAtBound(*bound, random) : kNoBound;
}

void addTrial(FixStudyRow& row, const FixScene& scene, const FixNoise& noise, int trials, RandomStream& random,
              RandomStream& bound_random)
{
  const double r1 = predictRange(scene.first, scene.landmark) + noise.first_range * random.gaussian();
  const double r2 = predictRange(scene.second, scene.landmark) + noise.second_range * random.gaussian();
  const FixMeasurement measured = measureFix(scene, std::abs(r1), std::abs(r2), noise, random);
  const auto fix = closedFormFix(measured);
  const auto likeliest = likeliestFix(measured);
  if (!fix || !likeliest) return;
  const Vector2d truth = scene.second.position();
  row.missed += fix->from_gap ? 1. / trials : 0;
  row.fix.add((fix->pose.mean.position() - truth).norm());
  row.likeliest.add((likeliest->mean.position() - truth).norm());
  row.fix_bound.add(drawnError(fixBound(scene, noise, false), bound_random));
  row.likeliest_bound.add(drawnError(fixBound(scene, noise, true), bound_random));
}
}  // namespace

std::vector<FixStudyRow> runFixStudy(const Settings& settings)
{
  const std::string s = "Study";
  const int trials = trialsOf(settings);
  FixNoise noise;
  noise.first_range = noise.second_range = settings.number(s, "std_range_m");
  noise.heading = settings.radians(s, "std_heading_deg");
  noise.bearing = settings.radians(s, "std_bearing_deg");
  std::vector<FixStudyRow> rows;
  for (const double ratio : settings.numbers(s, "ratios"))
    for (const double displacement_error : settings.numbers(s, "displacement_errors"))
    {
      const double way = ratio * noise.first_range;
      noise.displacement = displacement_error * way;
      FixStudyRow row;
      row.ratio = ratio;
      row.displacement_error = displacement_error;
      RandomStream random(seedOf(settings), 1), bound_random(seedOf(settings), 2);
      for (int trial = 0; trial < trials; ++trial)
        addTrial(row, randomScene(settings, way, random), noise, trials, random, bound_random);
      rows.push_back(std::move(row));
    }
  return rows;
}
}  // namespace mrpt_ext::papers
