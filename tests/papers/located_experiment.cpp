#include "located_experiment.h"

#include "error_at_bound.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/running_fix.h"
#include "paper_settings.h"
#include "running_fix_trial.h"

namespace mrpt_ext::papers
{
namespace
{
struct Way
{
  double length = 0;
  bool ahead = false;
};

/// A trial in which the corner is seen from both places; nothing when it is not.
std::optional<FixScene> sceneFrom(const StereoField& field, const Pose2& second, const Way& way, RandomStream& random)
{
  const double direction = way.ahead ? second.phi : random.uniform(-kPi, kPi);
  const Pose2 first{second.x - way.length * std::cos(direction), second.y - way.length * std::sin(direction),
                    second.phi};
  const auto corner = nearestSeen(field, second);
  if (!corner || !field.contains(first.position()) || !seen(field, first, corner->corner)) return std::nullopt;
  return FixScene{first, second, corner->corner};
}

struct Ranges
{
  double first = 0, second = 0;
};

std::optional<Ranges> wholePixelRanges(const StereoField& field, double width, const FixScene& scene)
{
  const auto first = wholePixelRange(field, width, *seen(field, scene.first, scene.landmark));
  const auto second = wholePixelRange(field, width, *seen(field, scene.second, scene.landmark));
  if (!first || !second) return std::nullopt;
  return Ranges{first->range, second->range};
}

FixNoise noiseOf(const Settings& settings, const StereoField& field, double width, const FixScene& scene, double length)
{
  const std::string s = "RunningFix";
  FixNoise noise;
  noise.first_range = rangeBound(field, width, kRounding, *seen(field, scene.first, scene.landmark));
  noise.second_range = rangeBound(field, width, kRounding, *seen(field, scene.second, scene.landmark));
  noise.displacement = settings.number(s, "displacement_error") * length;
  noise.heading = settings.radians(s, "std_heading_deg");
  noise.bearing = settings.radians(s, "std_bearing_deg");
  return noise;
}

/// Which rules call this trial located.
std::array<bool, kLocatedRules> located(const StereoField& field, const FixMeasurement& measured)
{
  const RunningFixPoses poses = runningFixPoses(measured.reading, measured.landmark, measured.heading);
  int inside = 0;
  bool meets = !poses.candidates.empty();
  for (const RunningFixPose& candidate : poses.candidates)
  {
    meets = meets && !candidate.from_gap;
    inside += field.contains(candidate.pose.mean.position()) ? 1 : 0;
  }
  return {meets, meets && inside > 0, meets && inside == 1};
}

LocatedShares tryWay(const Settings& settings, const StereoField& field, const Way& way, bool any_heading, int trials)
{
  LocatedShares shares{way.length, way.ahead, any_heading, field.range_scale, {}};
  for (auto& by_width : shares.share) by_width.assign(field.widths.size(), 0);
  RandomStream random(seedOf(settings), 1), noise(seedOf(settings), 2);
  for (int trial = 0; trial < trials;)
  {
    const auto scene = sceneFrom(field, randomPose(field, random), way, random);
    if (!scene && !any_heading) continue;
    ++trial;
    for (std::size_t w = 0; scene && w < field.widths.size(); ++w)
    {
      const auto ranges = wholePixelRanges(field, field.widths[w], *scene);
      if (!ranges) continue;
      const FixNoise std = noiseOf(settings, field, field.widths[w], *scene, way.length);
      const auto by_rule = located(field, measureFix(*scene, ranges->first, ranges->second, std, noise));
      for (std::size_t rule = 0; rule < kLocatedRules; ++rule) shares.share[rule][w] += by_rule[rule] ? 1. / trials : 0;
    }
  }
  return shares;
}

void add(LocatedErrors::Method& errors, const Pose2& found, const Pose2& truth)
{
  errors.dx.add(std::abs(found.x - truth.x));
  errors.dy.add(std::abs(found.y - truth.y));
  errors.distance.add((found.position() - truth.position()).norm());
  errors.heading.add(std::abs(wrap(found.phi - truth.phi)));
}

void addErrors(const Settings& settings, const StereoField& field, const FixScene& scene, LocatedErrors& errors,
               RandomStream& random)
{
  const auto ranges = wholePixelRanges(field, errors.width, scene);
  if (!ranges) return;
  const double length = (scene.second.position() - scene.first.position()).norm();
  const FixNoise noise = noiseOf(settings, field, errors.width, scene, length);
  FixMeasurement measured = measureFix(scene, ranges->first, ranges->second, noise, random);
  const auto closed = closedFormFix(measured);
  if (!closed || closed->from_gap) return;
  measured.reading.first_range /= field.range_scale;
  measured.reading.second_range /= field.range_scale;
  const auto likeliest = likeliestFix(measured);
  const auto bound = fixBound(scene, noise, true);
  if (!likeliest || !bound) return;
  add(errors.closed_form, closed->pose.mean, scene.second);
  add(errors.best, likeliest->mean, scene.second);
  const Vector2d e = Vector2d(bound->llt().matrixL() * Vector2d(random.gaussian(), random.gaussian()));
  add(errors.bound, {scene.second.x + e.x(), scene.second.y + e.y(), scene.second.phi}, scene.second);
}
}  // namespace

bool LocatedShares::matchesPaper(LocatedRule rule) const
{
  const auto& shares = share[static_cast<std::size_t>(rule)];
  for (std::size_t w = 0; w < shares.size(); ++w)
  {
    const double std = std::sqrt(shares[w] * (1 - shares[w]) * LocatedExperiment::kOf);
    if (std::abs(shares[w] * LocatedExperiment::kOf - LocatedExperiment::kPrinted[w]) > 2 * std) return false;
  }
  return true;
}

LocatedExperiment runLocatedExperiment(const Settings& settings)
{
  const StereoField field = readStereoField(settings);
  LocatedExperiment e;
  e.trials_per_share = trialsOf(settings) * static_cast<int>(settings.integer("RunningFix", "repetitions"));
  StereoField tried = field;
  for (const double scale : {field.range_scale, 1.0})
    for (const bool any_heading : {false, true})
      for (const bool ahead : {false, true})
        for (const double length : settings.numbers("RunningFix", "displacements_m"))
        {
          tried.range_scale = scale;
          e.tried.push_back(tryWay(settings, tried, {length, ahead}, any_heading, e.trials_per_share));
        }

  const Way judged{settings.number("RunningFix", "judged_displacement_m"), false};
  for (const double width : field.widths)
  {
    LocatedErrors errors{width, {}, {}, {}};
    RandomStream random(seedOf(settings), 3), noise(seedOf(settings), 4);
    for (int trial = 0; trial < e.trials_per_share;)
      if (const auto scene = sceneFrom(field, randomPose(field, random), judged, random))
      {
        ++trial;
        addErrors(settings, field, *scene, errors, noise);
      }
    e.errors.push_back(std::move(errors));
  }
  return e;
}
}  // namespace mrpt_ext::papers
