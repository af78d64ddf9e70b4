#include "mrpt_ext/correspondence/bearings/bearing_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mrpt_ext/correspondence/bearings/bearing_candidates.h"
#include "mrpt_ext/correspondence/bearings/search_strategy.h"
#include "mrpt_ext/correspondence/bearings/visibility_vote.h"
#include "mrpt_ext/correspondence/false_alarms_bearings.h"
#include "mrpt_ext/correspondence/pose_verification.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/correspondence/triple_schedule.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kListMargin = 0.02;  // of the range limit
constexpr int kLeastMatches = 4;      // three bearings are explained by every constellation
constexpr std::size_t kJudgedAtOnce = 64;
constexpr std::size_t kBoxes = 4'000'000;  // of a scan that are kept
constexpr std::size_t kMaxJudged = 5000;
constexpr double kChanceCompetes = 3e-3;  // expected false poses as good as the best
constexpr double kNegligible = 1e-3;      // evidence relative to the best pose's

class SearchRun
{
 public:
  SearchRun(const LandmarkIndex& map, std::span<const Scan> places, const PoseSearchOptions& options,
            std::vector<ScanBearing> readings, const BearingSearch& owner)
      : map_(map),
        places_(places),
        options_(options),
        readings_(std::move(readings)),
        owner_(owner),
        proposer_(map, places, options, readings_, owner),
        log_evidence_below_(logEvidenceOfUnsearched(map, places, areaOrMap(map, options.area)))
  {
  }

  PoseSearchResult run()
  {
    const std::vector<double> allowed = landmarksAllowed();
    mean_allowed_ = std::accumulate(allowed.begin(), allowed.end(), 0.0) / static_cast<double>(allowed.size());
    const std::vector<ReadingTriple> candidates =
        tripleCandidates(readings_, {allowed, ranges(), mapArea(), chanceMatches().chance});
    const int usable = static_cast<int>(readings_.size());
    const std::shared_ptr<const PanoramaIndex> panoramas = choosePanoramasFor(candidates);
    for (int misses = expectedMisses();;)
    {
      floor_ = std::max(leastMatches(), usable - misses);
      if (panoramas && usable - floor_ <= kMostPanoramaMisses)
        scanDownTo(*panoramas);
      else
        searchDownTo(candidates);
      if (!result_.finished || floor_ <= leastNeeded()) break;
      if (overflowed_) result_.finished = false;
      if (overflowed_) break;
      misses = best_matched_ > 0 ? usable - leastNeeded() : 2 * misses + 2;
    }
    finish();
    return std::move(result_);
  }

 private:
  // ---- what is known beforehand

  [[nodiscard]] double mapArea() const
  {
    const Vector2d extent = map_.high() - map_.low();
    return std::max(extent.prod(), 1e-3 * extent.squaredNorm() + 1e-9);
  }

  [[nodiscard]] std::vector<double> ranges() const
  {
    std::vector<double> result;
    for (const Scan& place : places_) result.push_back(rangeLimit(place));
    return result;
  }

  [[nodiscard]] std::vector<double> landmarksAllowed() const
  {
    std::vector<double> of_kind(static_cast<std::size_t>(map_.categoryCount()), 0);
    for (std::size_t l = 0; l < map_.size(); ++l) of_kind[static_cast<std::size_t>(map_.kind(l))] += 1;
    std::vector<double> allowed;
    for (const ScanBearing& r : readings_)
      allowed.push_back(r.kind == kAnyCategory ? static_cast<double>(map_.size())
                                               : of_kind[static_cast<std::size_t>(r.kind)]);
    return allowed;
  }

  // ---- rounds

  /// So many readings without a landmark are looked for at first, going by what the sensors declare.
  [[nodiscard]] int expectedMisses() const
  {
    double mean = 0;
    for (const ScanBearing& r : readings_) mean += places_[static_cast<std::size_t>(r.place)].model.clutter_probability;
    constexpr double kRounding = 1e-9;  // one false reading of 21 must not count as two
    return static_cast<int>(std::ceil(mean - kRounding)) + 1;
  }

  /// Rounds until every pose that matters and explains `floor_` readings has been proposed.
  void searchDownTo(const std::vector<ReadingTriple>& candidates)
  {
    TripleSchedule cover(candidates);
    proposer_.waiting().clear();
    const int usable = static_cast<int>(readings_.size());
    while (result_.finished && cover.tolerated() < usable - std::max(leastNeeded(), floor_) + spareRounds())
    {
      const std::optional<ReadingTriple> triple = cover.next();
      if (!triple) break;
      propose(*triple);
      if (result_.finished) tolerated_ = std::max(tolerated_, cover.tolerated());
      judgeBest(kJudgedAtOnce);
    }
    judgeBest(std::numeric_limits<std::size_t>::max());
  }

  /// The panoramas to count off, when that is cheaper than triples.
  [[nodiscard]] std::shared_ptr<const PanoramaIndex> choosePanoramasFor(const std::vector<ReadingTriple>& candidates)
  {
    const int place = readings_.front().place;
    const auto area = proposer_.areaOfSensor(place);
    if (!area || candidates.empty()) return nullptr;
    const auto cheapest = std::min_element(candidates.begin(), candidates.end(),
                                           [](const auto& a, const auto& b) { return a.cost < b.cost; });
    const double max_range = rangeLimit(places_[static_cast<std::size_t>(place)]);
    const std::shared_ptr<const PanoramaIndex> built = owner_.builtPanoramas(*area, max_range);
    const TripleEffort triples = proposer_.sampleEffort(*cheapest);
    const auto plan = choosePanoramas(map_, *area, max_range, readings_, options_.gate, triples, expectedMisses() - 1,
                                      built ? &built->plan() : nullptr);
    if (!plan) return nullptr;
    return built && built->plan().cell == plan->cell ? built : owner_.panoramasFor(*plan);
  }

  /// Proposes and judges every pose that matters and explains `floor_` readings, those that explain most first.
  void scanDownTo(const PanoramaIndex& panoramas)
  {
    const int usable = static_cast<int>(readings_.size());
    const PanoramaHits hits = scanPanoramas(panoramas, readings_, options_.gate, floor_, kBoxes);
    ++result_.work.rounds;
    result_.work.tested += panoramas.plan().cells();
    overflowed_ = hits.floor > floor_;
    floor_ = hits.floor;
    tolerated_ = usable - floor_;
    proposer_.waiting().clear();
    for (int level = usable; level >= std::max(floor_, leastNeeded()); --level)
    {
      proposer_.proposeFrom(hits.by_explained[static_cast<std::size_t>(level)], panoramas, readings_.front().place,
                            std::max(floor_, leastNeeded()));
      judgeBest(std::numeric_limits<std::size_t>::max(), level);
    }
  }

  void propose(const ReadingTriple& triple)
  {
    const int floor = std::max(leastNeeded(), floor_);
    const int kept = proposer_.proposeFrom(triple, floor, leastNeeded());
    result_.finished = proposer_.finished();
    overflowed_ = overflowed_ || kept > floor;
    if (kept > floor) floor_ = kept;
  }

  // ---- judging

  /// Judges the proposals that explain most, as long as they can matter and explain at least `lowest` readings.
  void judgeBest(std::size_t count, int lowest = 0)
  {
    int least = std::max(lowest, leastNeeded());
    for (std::size_t level = proposer_.waiting().size(); level-- > 0;)
    {
      std::vector<GaussianPose>& waiting = proposer_.waiting()[level];
      std::size_t next = 0;
      for (; next < waiting.size() && count > 0 && result_.finished && static_cast<int>(level) >= least; ++next)
        if (!isKnown(waiting[next]))
        {
          judge(waiting[next]);
          if (!result_.finished) complete_from_ = std::max(complete_from_, static_cast<int>(level) + 1);
          least = std::max(lowest, leastNeeded());
          --count;
        }
      waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(next));
    }
  }

  void judge(const GaussianPose& robot)
  {
    if (result_.work.judged >= kMaxJudged)
    {
      result_.finished = false;
      return;
    }
    ++result_.work.judged;
    const auto pose = verifyPose(map_, places_, options_, robot, leastNeeded());
    if (!pose) return;
    best_matched_ = std::max(best_matched_, pose->matched);
    best_log_evidence_ = std::max(best_log_evidence_, pose->log_evidence);
    result_.poses.push_back(*pose);
  }

  /// True when a pose that was judged already is as good as the same.
  [[nodiscard]] bool isKnown(const GaussianPose& robot) const
  {
    const auto same = [&](const ConsistentPose& p)
    {
      const Vector3d e(p.pose.mean.x - robot.mean.x, p.pose.mean.y - robot.mean.y,
                       wrap(p.pose.mean.phi - robot.mean.phi));
      for (Eigen::Index k = 0; k < 3; ++k)
        if (square(e(k)) > 0.25 * p.pose.covariance(k, k)) return false;
      return true;
    };
    return std::any_of(result_.poses.begin(), result_.poses.end(), same);
  }

  // ---- what may be left out

  /// About one true triple in fifteen fixes its pose too weakly to come through. Where chance can compete with the
  /// truth that calls for one more.
  [[nodiscard]] int spareRounds() const
  {
    return best_matched_ > 0 && expectedFalsePoses(chanceMatches(), best_matched_) > kChanceCompetes ? 1 : 0;
  }

  [[nodiscard]] int leastMatches() const { return std::min(kLeastMatches, static_cast<int>(readings_.size())); }

  /// Poses that explain fewer readings can be left out: their evidence together is negligible.
  [[nodiscard]] int leastNeeded() const
  {
    if (best_matched_ == 0) return leastMatches();
    int least = best_matched_;
    while (least > leastMatches() && logEvidenceOfFewer(least) > best_log_evidence_ + std::log(kNegligible)) --least;
    return least;
  }

  /// Than `least` matches.
  [[nodiscard]] double logEvidenceOfFewer(int least) const
  {
    return log_evidence_below_[std::min(static_cast<std::size_t>(least), log_evidence_below_.size() - 1)];
  }

  [[nodiscard]] FalseAlarmModel chanceMatches() const
  {
    const double triples = proposer_.meanPossible();
    const Scan& place = places_[static_cast<std::size_t>(readings_.front().place)];
    return {triples, static_cast<int>(readings_.size()),
            chanceOfMatch(options_.gate * meanStd(), std::max(0.0, inView(place) - 3))};
  }

  [[nodiscard]] double meanStd() const
  {
    double sum = 0;
    for (const ScanBearing& r : readings_) sum += r.std;
    return sum / static_cast<double>(readings_.size());
  }

  /// Mean number of landmarks in view that a reading may show.
  [[nodiscard]] double inView(const Scan& place) const
  {
    const double range = rangeLimit(place);
    return std::isfinite(range) ? mean_allowed_ * std::min(1.0, kPi * square(range) / mapArea()) : mean_allowed_;
  }

  void finish()
  {
    const int searched = std::max({floor_, complete_from_, static_cast<int>(readings_.size()) - tolerated_});
    const double missed = result_.poses.empty() ? -kUnlimited : logEvidenceOfFewer(searched);
    if (!result_.poses.empty()) result_.expected_false = expectedFalsePoses(chanceMatches(), best_matched_);
    result_.work.tested += proposer_.work().tested;
    result_.work.rounds += proposer_.work().rounds;
    rankPoses(result_, options_, missed, searched);
    result_.unique = result_.unique && result_.finished;
  }

  const LandmarkIndex& map_;
  std::span<const Scan> places_;
  const PoseSearchOptions& options_;
  std::vector<ScanBearing> readings_;
  const BearingSearch& owner_;
  BearingCandidates proposer_;
  PoseSearchResult result_;
  std::vector<double> log_evidence_below_;  // by the number of matches
  double best_log_evidence_ = -kUnlimited;
  int best_matched_ = 0, floor_ = 0, tolerated_ = -1;
  int complete_from_ = 0;    // with so many matches every pose that was proposed has been judged
  bool overflowed_ = false;  // more proposals than can be kept: the lesser ones are lost
  double mean_allowed_ = 0;
};
}  // namespace

PoseSearchResult BearingSearch::search(std::span<const Scan> places, const PoseSearchOptions& options) const
{
  PoseSearchResult nothing;
  if (!areUsable(places)) nothing.status = SolveStatus::bad_input;
  std::vector<ScanBearing> readings = gatherBearings(places);
  if (nothing.status == SolveStatus::bad_input || readings.size() < 3) return nothing;
  if (map_.size() < 3)
  {
    nothing.status = SolveStatus::none;
    return nothing;
  }
  return SearchRun(map_, places, options, std::move(readings), *this).run();
}

std::shared_ptr<const PotentiallyVisibleSets> BearingSearch::listsFor(double max_range) const
{
  const std::scoped_lock lock(mutex_);
  for (const auto& lists : lists_)
    if (lists->maxRange() == max_range) return lists;
  const double margin = std::isfinite(max_range) ? kListMargin * max_range : 0;
  return lists_.emplace_back(std::make_shared<const PotentiallyVisibleSets>(map_, max_range, margin));
}

std::shared_ptr<const NeighbourGrid> BearingSearch::neighboursOf(int kind) const
{
  const std::scoped_lock lock(mutex_);
  auto& grid = neighbours_[kind];
  if (!grid) grid = std::make_shared<const NeighbourGrid>(map_, kind);
  return grid;
}

std::shared_ptr<const PanoramaIndex> BearingSearch::panoramasFor(const PanoramaIndex::Plan& plan) const
{
  const std::scoped_lock lock(mutex_);
  for (const auto& panoramas : panoramas_)
    if (panoramas->isOf(plan.area, plan.max_range) && panoramas->plan().cell == plan.cell) return panoramas;
  constexpr std::size_t kKept = 2;  // areas that change from search to search must not fill the memory
  if (panoramas_.size() == kKept) panoramas_.erase(panoramas_.begin());
  return panoramas_.emplace_back(std::make_shared<const PanoramaIndex>(map_, plan));
}

std::shared_ptr<const PanoramaIndex> BearingSearch::builtPanoramas(const Box2& area, double max_range) const
{
  const std::scoped_lock lock(mutex_);
  const auto found = std::find_if(panoramas_.begin(), panoramas_.end(),
                                  [&](const auto& panoramas) { return panoramas->isOf(area, max_range); });
  return found == panoramas_.end() ? nullptr : *found;
}
}  // namespace mrpt_ext
