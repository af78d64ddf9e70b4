#include "range_experiment.h"

#include "paper_settings.h"

namespace mrpt_ext::papers
{
namespace
{
void add(RangeErrors& errors, double measured, double truth)
{
  errors.absolute.add(std::abs(measured - truth));
  errors.relative.add(std::abs(measured - truth) / truth);
}

void addCorner(const StereoField& field, const SeenCorner& corner, RangeResult& result, RandomStream& random)
{
  const auto whole = wholePixelRange(field, result.width, corner);
  const auto fine = subPixelRange(field, result.width, corner, random);
  if (!whole || !fine) return;
  add(result.paper, whole->range, corner.range);
  add(result.calibrated, whole->range / field.range_scale, corner.range);
  add(result.best, fine->range / field.range_scale, corner.range);
  const double bound = rangeBound(field, result.width, field.std_subpixel, corner);
  add(result.bound, corner.range + bound * random.gaussian(), corner.range);
}
}  // namespace

std::vector<RangeResult> runRangeExperiment(const Settings& settings)
{
  const StereoField field = readStereoField(settings);
  const std::vector<double> counts = settings.numbers("Ranges", "measurements");
  std::vector<RangeResult> results;
  for (std::size_t w = 0; w < field.widths.size(); ++w)
  {
    RangeResult result;
    result.width = field.widths[w];
    RandomStream random(seedOf(settings), w), noise(seedOf(settings), 100 + w);
    const auto is_done = [&] { return static_cast<double>(result.paper.absolute.count()) >= counts.at(w); };
    while (!is_done())
      for (const SeenCorner& corner : allSeen(field, randomPose(field, random)))
        if (!is_done()) addCorner(field, corner, result, noise);
    results.push_back(std::move(result));
  }
  return results;
}

std::vector<std::vector<RangeResult>> tryOtherPlaces(Settings settings)
{
  std::vector<std::vector<RangeResult>> all;
  for (const double margin : settings.numbers("Ranges", "other_margins_m"))
    for (const double min_range : settings.numbers("Ranges", "other_min_ranges_m"))
    {
      settings.set("Stereo", "margin_m", shortestText(margin), "other_margins_m");
      settings.set("Stereo", "min_range_m", shortestText(min_range), "other_min_ranges_m");
      all.push_back(runRangeExperiment(settings));
    }
  return all;
}
}  // namespace mrpt_ext::papers
