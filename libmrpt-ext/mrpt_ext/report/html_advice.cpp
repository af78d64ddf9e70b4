#include "mrpt_ext/report/html_advice.h"

#include "mrpt_ext/report/html_parts.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSameRow = 10;        // [s] between injections of one row
constexpr std::size_t kMostRows = 20;  // of the table

/// Injections that follow each other closely.
struct ReseedingSpell
{
  double from = 0, to = 0;  // [s]
  std::size_t count = 0;
  std::string reason;  // of the first
};

std::vector<ReseedingSpell> spellsOf(const std::vector<Reseeding>& reseedings, double start)
{
  std::vector<ReseedingSpell> spells;
  for (const Reseeding& reseeding : reseedings)
  {
    const double time = reseeding.time - start;
    if (spells.empty() || time - spells.back().to > kSameRow) spells.push_back({time, time, 0, reseeding.reason});
    spells.back().to = time;
    ++spells.back().count;
  }
  return spells;
}

std::string item(const std::string& verdict, const std::string& text)
{
  return element("li", "", element("b", "", verdict) + ": " + text) + "\n";
}

bool any(const OptionalNumber& share) { return share.value_or(0) > 0; }
}  // namespace

std::string reseedingTable(const RunRecord& record, const RunContext& context)
{
  const std::vector<ReseedingSpell> spells = spellsOf(record.filter.reseedings, context.start_time);
  if (spells.empty()) return {};
  std::string rows;
  for (std::size_t k = 0; k < std::min(spells.size(), kMostRows); ++k)
    rows += htmlRow({numberText(spells[k].from, 1) + " to " + numberText(spells[k].to, 1) + " s",
                     std::to_string(spells[k].count), escapeHtml(spells[k].reason)});
  if (spells.size() > kMostRows) rows += htmlRow({std::to_string(spells.size() - kMostRows) + " more", "", ""});
  return htmlTable({"from start of log", "injections", "why"}, rows, "spells");
}

std::string adviceList(const RunScore& score)
{
  std::string items;
  if (any(score.verdict_shares.ambiguous) || score.verdict == Verdict::ambiguous)
    items +=
        item("ambiguous, several modes or not verified yet",
             "drive on, until other landmarks come into view. A map that looks the same from two places needs a known "
             "start (<code>init_PDF_mode = gaussian</code>), ids, or a landmark that breaks the symmetry.") +
        item("ambiguous, not precise",
             "too few landmarks in view, standard deviations that are declared too large, or sensors that cannot give "
             "what <code>ok_max_std_m</code> and <code>ok_max_std_deg</code> ask: set what is enough for you.") +
        item("ambiguous, few inliers",
             "the detections disagree with the map: <code>--diagnose</code> tells delays, offsets, noise and "
             "outliers, <code>--calibrate FILE.ini</code> sets them.");
  if (any(score.verdict_shares.lost) || score.verdict == Verdict::lost)
    items += item("lost from the start to the end",
                  "map, signs or frames are wrong: the order of x and y, bearings counted clockwise, the pose of the "
                  "sensor on the robot, or a map of another place.") +
             item("lost for a while",
                  "the robot was carried, slipped, or stood where few mapped landmarks are. If odometry slips often, "
                  "larger noise in <code>[MotionModel]</code> helps.");
  if (score.filter.reseeds.value_or(0) > 0)
    items +=
        item("injected hypotheses",
             "a few that end in <code>ok</code> are a recovery that worked. Many are a sign of declared noise that is "
             "too small, or of a sensor that is late: <code>--diagnose</code>.");
  return items.empty() ? items : element("ul", "", "\n" + items) + "\n";
}
}  // namespace mrpt_ext
