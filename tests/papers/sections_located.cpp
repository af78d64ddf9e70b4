#include <cmath>

#include "printed_rows.h"
#include "sections.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr double kCm = 0.01;
const double kDeg = degToRad(1);
const std::string kScenario = "tests/papers/paper-004-located.ini";
const char* const kTables[] = {"table 1, QVGA", "table 2, VGA"};

int matching(const LocatedExperiment& e)
{
  int count = 0;
  for (const LocatedShares& shares : e.tried)
    for (int rule = 0; rule < kLocatedRules; ++rule)
      count += shares.matchesPaper(static_cast<LocatedRule>(rule)) ? 1 : 0;
  return count;
}

/// Smallest and largest count of 500 among all that was tried.
std::pair<double, double> countRange(const LocatedExperiment& e, std::size_t width)
{
  Sample counts;
  for (const LocatedShares& shares : e.tried)
    for (const auto& by_rule : shares.share) counts.add(by_rule[width] * LocatedExperiment::kOf);
  return {counts.quantile(0), counts.quantile(1)};
}

ResultSection countSection(const LocatedExperiment& e)
{
  const std::size_t combinations = e.tried.size() * kLocatedRules;
  ResultSection s;
  s.title = "Paper 004, tables 1 and 2: trials that are located";
  s.scenarios = {kScenario};
  s.paragraph =
      "Of 500 trials with the coarse images the paper locates 176, with the fine ones 381, and says that nothing "
      "else was changed. It does not say how far the robot drove between the two ranges, in which direction, what it "
      "knew of its way, where it stood, nor when a trial counts. We tried " +
      std::to_string(combinations) +
      " combinations: ways of 5 to 50 cm, straight ahead or in any direction, trials that begin with a corner in "
      "view or anywhere, ranges as they are or five per cent too long, and three meanings of \"located\". " +
      (matching(e) == 0 ? "None gives both counts within two standard deviations of a repetition. "
                        : std::to_string(matching(e)) + " give both counts within two standard deviations. ") +
      "Twice the resolution halves the error of a range, and that alone moves the share of circles that meet far less "
      "than from 35 to 76 %. Each cell is the count for 320 and for 640 columns, per 500; the standard deviation of a "
      "repetition of 500 trials is at most 11.";
  for (std::size_t w = 0; w < 2; ++w)
  {
    const auto [low, high] = countRange(e, w);
    ResultRow row{.what = std::string(kTables[w]) + ": located of 500"};
    row.paper = fixedText(LocatedExperiment::kPrinted[w], 0);
    row.closed_form = fixedText(low, 0) + " to " + fixedText(high, 0);
    row.best = "500 (range, bearing and heading always give a place)";
    row.trials = std::to_string(e.trials_per_share) + " per combination";
    row.outcome = Outcome::input_missing;
    row.reason = "way, direction, dead reckoning and what counts as located; see what was tried";
    s.rows.push_back(row);
  }
  s.plain.push_back(
      {"way [m]", "direction", "trials begin", "ranges", "circles meet", "... inside the field", "... exactly once"});
  for (const LocatedShares& t : e.tried)
  {
    PlainRow row{fixedText(t.displacement, 2), t.ahead ? "ahead" : "any",
                 t.any_heading ? "anywhere" : "with a corner in view", t.range_scale == 1 ? "right" : "5 % too long"};
    for (const auto& shares : t.share)
      row.push_back(fixedText(500 * shares[0], 0) + " / " + fixedText(500 * shares[1], 0));
    s.plain.push_back(row);
  }
  return s;
}

ResultSection errorSection(const LocatedExperiment& e, const DriveErrors& drive)
{
  ResultSection s;
  s.title = "Paper 004, tables 1 and 2: errors of the places";
  s.scenarios = {kScenario, "tests/papers/paper-004-drive.ini", "ini/landmark-simulator/goal-corners-stereo.ini",
                 "ini/landmark-localization/goal-corners-stereo.ini"};
  s.paragraph =
      "Errors of the trials whose circles meet, for a way of 30 cm in any direction; of the two places the one is "
      "taken that the bearing speaks for; mean and standard deviation of absolute errors. Our best estimator uses "
      "the same two ranges with their scale taken off, the bearing and the heading, by maximum likelihood; the limit "
      "is drawn from its Cramer-Rao bound. A filter does without calibration and without a known heading: on drives "
      "of 20 s from an unknown start, one corner in view at a time and the scale of the ranges unknown, its error at "
      "the full seconds of the last 10 s that show a corner is in the last row (" +
      std::to_string(drive.distance.count()) + " drives, " + std::to_string(drive.lost) +
      " lost). Their pooled RMSE is " + fixedText(drive.rmse.rms() / kCm, 2) +
      " cm, its posterior Cramer-Rao bound, for ranges without the error, " + fixedText(drive.bound.rms() / kCm, 2) +
      " cm.";
  for (std::size_t w = 0; w < e.errors.size() && w < 2; ++w)
  {
    const LocatedErrors& errors = e.errors[w];
    const auto row = [&](const std::string& what, const std::string& printed, Sample LocatedErrors::Method::*figure,
                         double unit, bool bound)
    {
      ResultRow r{.what = std::string(kTables[w]) + ": " + what, .paper = printed};
      r.closed_form = (errors.closed_form.*figure).text(1, unit);
      r.best = (errors.best.*figure).text(1, unit);
      if (bound) r.limit = (errors.bound.*figure).text(1, unit);
      r.trials = std::to_string((errors.closed_form.*figure).count());
      r.outcome = Outcome::input_missing;
      r.reason = "the way, and what counts as located";
      s.rows.push_back(r);
    };
    const PrintedPoseErrors& printed = kPrintedPoseErrors[w];
    row("dx [cm]", printed.dx, &LocatedErrors::Method::dx, kCm, true);
    row("dy [cm]", printed.dy, &LocatedErrors::Method::dy, kCm, true);
    row("distance [cm]", "-", &LocatedErrors::Method::distance, kCm, true);
    row("heading by eq 7 [deg]", printed.heading, &LocatedErrors::Method::heading, kDeg, false);
  }
  ResultRow filter{.what = "QVGA, filter on a drive: mean dx, dy, distance [cm]"};
  filter.best = drive.dx.text(1, kCm) + ", " + drive.dy.text(1, kCm) + ", " + drive.distance.text(1, kCm);
  filter.limit = "RMSE " + fixedText(drive.bound.rms() / kCm, 2);
  filter.trials = std::to_string(drive.distance.count()) + " drives";
  filter.outcome = Outcome::input_missing;
  filter.reason = "the paper has no filter";
  s.rows.push_back(filter);
  return s;
}
}  // namespace

std::vector<ResultSection> sectionsLocated(const LocatedExperiment& located, const DriveErrors& drive)
{
  return {countSection(located), errorSection(located, drive)};
}

ResultSection sectionFixStudy(const std::vector<FixStudyRow>& rows)
{
  ResultSection s;
  s.title = "What paper 004 leaves open: how far to drive, and how well to know it";
  s.scenarios = {"tests/papers/paper-004-open-study.ini"};
  s.paragraph =
      "One landmark, the robot anywhere around it, its way in any direction, heading known to a degree. The error of "
      "the running fix falls with the way between the ranges against their error, until the error of dead reckoning, "
      "which grows with the way, takes over: with 10 % the way beyond 20 standard deviations of a range no longer "
      "helps. Half of the fixes whose way is as long as the error of a range have no intersection at all. One more "
      "number, the bearing to the same landmark, makes the second range nearly superfluous: the last columns hardly "
      "depend on way and dead reckoning. Limits are medians of errors drawn from the Cramer-Rao bound; for short ways "
      "the bound of the fix is larger than the error itself, because it speaks of small errors only, while circles "
      "keep even a bad fix within reach of the landmark. Errors in cm, medians, RMS in brackets.";
  s.plain.push_back({"way / error of a range", "dead reckoning", "circles miss", "running fix", "limit of it",
                     "with the bearing, maximum likelihood", "limit of that", "N"});
  const auto both = [](const Sample& sample)
  { return fixedText(100 * sample.median(), 1) + " (" + fixedText(100 * sample.rms(), 1) + ")"; };
  for (const FixStudyRow& r : rows)
    s.plain.push_back({fixedText(r.ratio, 0), percent(r.displacement_error), percent(r.missed), both(r.fix),
                       fixedText(100 * r.fix_bound.median(), 1), both(r.likeliest),
                       fixedText(100 * r.likeliest_bound.median(), 1), std::to_string(r.fix.count())});
  return s;
}
}  // namespace mrpt_ext::papers
