#include "movis_yaw_scan.h"

#include "movis_methods.h"
#include "mrpt_ext/settings/setting_value.h"
#include "paper_settings.h"

namespace mrpt_ext::papers
{
namespace
{
bool holds(const Sample& sample, double printed)
{
  return sample.quantile(0.05) <= printed && printed <= sample.quantile(0.95);
}

bool isPrintedWorse(const std::string& point)
{
  const auto names = parseWords(PrintedLattice::kWorseAt);
  return std::find(names.begin(), names.end(), point) != names.end();
}

void visitOnce(const MovisLattice& lattice, YawTry& tried, RandomStream& random)
{
  std::vector<MovisLook> looks;
  for (const Vector2d& place : lattice.places) looks.push_back(lookFrom(lattice, place, random));
  const OriginCorrection correction = paperCorrection(lattice, looks[lattice.origin]);
  Sample before, after, slope, agrees;
  for (std::size_t i = 0; i < looks.size(); ++i)
  {
    const auto raw = paperAnswer(lattice, looks[i]), corrected = paperAnswer(lattice, looks[i], correction);
    if (!raw || !corrected) continue;
    before.add((raw->position - lattice.places[i]).norm());
    after.add((corrected->position - lattice.places[i]).norm());
    if (i == lattice.origin) continue;
    slope.add(std::abs(corrected->slope));
    agrees.add((after.values().back() > before.values().back()) == isPrintedWorse(lattice.names[i]) ? 1 : 0);
  }
  tried.mean_before.add(before.mean());
  tried.mean_after.add(after.mean());
  tried.median_before.add(before.median());
  tried.median_after.add(after.median());
  tried.rms_ratio.add(after.rms() / before.rms());
  tried.slope_after.add(slope.mean());
  tried.agreement += agrees.mean();
}

void judge(YawTry& tried)
{
  using P = PrintedLattice;
  const std::pair<const Sample*, double> figures[] = {{&tried.mean_before, P::kMeanBefore},
                                                      {&tried.mean_after, P::kMeanAfter},
                                                      {&tried.median_before, P::kMedianBefore},
                                                      {&tried.median_after, P::kMedianAfter},
                                                      {&tried.rms_ratio, P::kRmsRatio}};
  double squares = square(1 - tried.agreement);
  tried.explains = true;
  for (const auto& [sample, printed] : figures)
  {
    squares += square(sample->median() / printed - 1);
    tried.explains = tried.explains && holds(*sample, printed);
  }
  tried.misfit = std::sqrt(squares);
}
}  // namespace

bool YawTry::explainsHeading() const { return holds(slope_after, degToRad(PrintedLattice::kHeadingDeg)); }

std::vector<YawTry> scanYaw(const Settings& settings)
{
  const std::string s = "YawScan";
  MovisLattice lattice = readLattice(settings);
  const int trials = static_cast<int>(settings.integer(s, "trials"));
  std::vector<YawTry> tries;
  for (const double std_deg : settings.numbers(s, "std_bearing_deg"))
    for (const double common_deg : settings.numbers(s, "common_deg"))
      for (const double difference_deg : settings.numbers(s, "difference_deg"))
      {
        YawTry tried;
        tried.std_bearing = lattice.std_bearing = degToRad(std_deg);
        tried.yaw = {degToRad(common_deg - difference_deg / 2), degToRad(common_deg + difference_deg / 2)};
        lattice.yaw = tried.yaw;
        RandomStream random(seedOf(settings), 2);  // the same noise for all
        for (int trial = 0; trial < trials; ++trial) visitOnce(lattice, tried, random);
        tried.agreement /= trials;
        judge(tried);
        tries.push_back(std::move(tried));
      }
  const auto better = [](const YawTry& a, const YawTry& b)
  { return a.explains != b.explains ? a.explains : a.misfit < b.misfit; };
  std::stable_sort(tries.begin(), tries.end(), better);
  return tries;
}

const YawTry* likeliestMount(const std::vector<YawTry>& tries)
{
  const double most = degToRad(0.5) + 1e-9;
  for (const YawTry& tried : tries)
    if (std::abs(tried.yaw[0]) <= most && std::abs(tried.yaw[1]) <= most) return &tried;
  return nullptr;
}
}  // namespace mrpt_ext::papers
