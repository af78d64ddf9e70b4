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
#include "mrpt_ext/correspondence/search_input.h"
#include "mrpt_ext/correspondence/triple_schedule.h"
#include "mrpt_ext/correspondence/unsearched_evidence.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr std::size_t kVerifiedAtOnce = 64;
constexpr std::size_t kBoxes = 4'000'000;  // of a vote that are kept
constexpr std::size_t kMostVerified = 5000;
constexpr double kChanceCompetes = 3e-3;  // expected false poses as good as the best
constexpr double kNegligible = 1e-3;      // evidence relative to the best pose's

class SearchRun
{
 public:
  SearchRun(const LandmarkIndex& map, std::span<const Scan> scans, const PoseSearchOptions& options,
            std::vector<ScanBearing> bearings, const BearingSearchTables& tables, WorkBudget& budget)
      : map_(map),
        scans_(scans),
        options_(options),
        bearings_(std::move(bearings)),
        tables_(tables),
        budget_(budget),
        proposing_(budget, kProposingShare),
        candidates_(map, scans, options, bearings_, tables, proposing_),
        log_evidence_below_(logEvidenceOfUnsearched(map, scans, areaOrMap(map, options.area)))
  {
  }

  PoseSearchResult run()
  {
    const std::vector<double> allowed = landmarksAllowed();
    mean_allowed_ = std::accumulate(allowed.begin(), allowed.end(), 0.0) / static_cast<double>(allowed.size());
    const std::vector<DetectionTriple> candidates =
        tripleCandidates(bearings_, {allowed, ranges(), mapArea(), falseAlarmModel().chance});
    const int usable = static_cast<int>(bearings_.size());
    const std::shared_ptr<const VisibilityGrid> grid = chooseGridFor(candidates);
    for (int misses = expectedMisses();;)
    {
      floor_ = std::max(leastMatches(), usable - misses);
      if (grid && usable - floor_ <= kMostOutliers)
        voteDownTo(*grid);
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
  // ---- properties of the input

  [[nodiscard]] double mapArea() const
  {
    const Vector2d extent = map_.high() - map_.low();
    return std::max(extent.prod(), 1e-3 * extent.squaredNorm() + 1e-9);
  }

  [[nodiscard]] std::vector<double> ranges() const
  {
    std::vector<double> result;
    for (const Scan& scan : scans_) result.push_back(rangeLimit(scan));
    return result;
  }

  [[nodiscard]] std::vector<double> landmarksAllowed() const
  {
    std::vector<double> of_category(static_cast<std::size_t>(map_.categoryCount()), 0);
    for (std::size_t l = 0; l < map_.size(); ++l) of_category[static_cast<std::size_t>(map_.category(l))] += 1;
    std::vector<double> allowed;
    for (const ScanBearing& r : bearings_)
      allowed.push_back(r.category == kAnyCategory ? static_cast<double>(map_.size())
                                                   : of_category[static_cast<std::size_t>(r.category)]);
    return allowed;
  }

  // ---- rounds

  /// Number of outliers allowed in the first round, from the declared clutter probabilities.
  [[nodiscard]] int expectedMisses() const
  {
    double mean = 0;
    for (const ScanBearing& r : bearings_) mean += scans_[static_cast<std::size_t>(r.scan)].model.clutter_probability;
    constexpr double kRounding = 1e-9;  // one false bearing of 21 must not count as two
    return static_cast<int>(std::ceil(mean - kRounding)) + 1;
  }

  /// Rounds until every pose that matters and has `floor_` inliers has been proposed.
  void searchDownTo(const std::vector<DetectionTriple>& candidates)
  {
    TripleSchedule schedule(candidates, proposing_);
    candidates_.pending().clear();
    const int usable = static_cast<int>(bearings_.size());
    while (result_.finished && schedule.tolerated() < usable - std::max(leastNeeded(), floor_) + spareRounds())
    {
      const std::optional<DetectionTriple> triple = schedule.next();
      if (triple) propose(*triple);
      if (proposing_.exhausted()) result_.finished = false;
      if (!triple) break;
      if (result_.finished) tolerated_ = std::max(tolerated_, schedule.tolerated());
      verifyBest(kVerifiedAtOnce);
    }
    verifyBest(std::numeric_limits<std::size_t>::max());
  }

  /// The grid to vote on, if that is cheaper than triples.
  [[nodiscard]] std::shared_ptr<const VisibilityGrid> chooseGridFor(const std::vector<DetectionTriple>& candidates)
  {
    const int scan = bearings_.front().scan;
    const auto area = candidates_.areaOfSensor(scan);
    if (!area || candidates.empty()) return nullptr;
    const auto cheapest = std::min_element(candidates.begin(), candidates.end(),
                                           [](const auto& a, const auto& b) { return a.cost < b.cost; });
    const double max_range = rangeLimit(scans_[static_cast<std::size_t>(scan)]);
    const std::shared_ptr<const VisibilityGrid> built = tables_.builtVisibilityGrid(*area, max_range);
    const TripleEffort triples = candidates_.sampleEffort(*cheapest);
    const auto layout = chooseVisibilityGrid(map_, *area, max_range, bearings_, options_.gate, triples,
                                             expectedMisses() - 1, built ? &built->layout() : nullptr);
    if (!layout) return nullptr;
    return built && built->layout().cell == layout->cell ? built : tables_.visibilityGrid(*layout);
  }

  /// Proposes and verifies every pose that matters and has `floor_` inliers, those with most inliers first.
  void voteDownTo(const VisibilityGrid& grid)
  {
    const int usable = static_cast<int>(bearings_.size());
    const PoseBoxes hits = voteForPoses(grid, bearings_, options_.gate, floor_, kBoxes, proposing_);
    ++result_.work.rounds;
    result_.work.tested += grid.layout().cells();
    overflowed_ = hits.floor > floor_;
    floor_ = hits.floor;
    candidates_.pending().clear();
    for (int level = usable; level >= std::max(floor_, leastNeeded()); --level)
    {
      candidates_.propose(hits.by_inliers[static_cast<std::size_t>(level)], grid, bearings_.front().scan,
                          std::max(floor_, leastNeeded()));
      verifyBest(std::numeric_limits<std::size_t>::max(), level);
    }
    if (proposing_.exhausted()) result_.finished = false;
    if (result_.finished) tolerated_ = usable - floor_;
  }

  void propose(const DetectionTriple& triple)
  {
    const int floor = std::max(leastNeeded(), floor_);
    const int kept = candidates_.propose(triple, floor, leastNeeded());
    overflowed_ = overflowed_ || kept > floor;
    if (kept > floor) floor_ = kept;
  }

  // ---- verification

  /// Verifies the candidates with most inliers, as long as they matter and have at least `lowest` inliers.
  void verifyBest(std::size_t count, int lowest = 0)
  {
    int least = std::max(lowest, leastNeeded());
    for (std::size_t level = candidates_.pending().size(); level-- > 0;)
    {
      std::vector<GaussianPose>& pending = candidates_.pending()[level];
      std::size_t next = 0;
      for (; next < pending.size() && count > 0 && static_cast<int>(level) >= least; ++next)
      {
        if (!mayVerify()) return leaveUnverifiedBelow(static_cast<int>(level) + 1);
        if (isKnown(pending[next])) continue;
        verify(pending[next]);
        least = std::max(lowest, leastNeeded());
        --count;
      }
      pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(next));
    }
  }

  [[nodiscard]] bool mayVerify()
  {
    return result_.work.verified < kMostVerified && budget_.spend(2 * result_.poses.size());
  }

  void leaveUnverifiedBelow(int inliers)
  {
    result_.finished = false;
    complete_from_ = std::max(complete_from_, inliers);
  }

  void verify(const GaussianPose& robot)
  {
    ++result_.work.verified;
    const auto pose = verifyPose(map_, scans_, options_, robot, leastNeeded());
    if (!pose) return;
    best_matched_ = std::max(best_matched_, pose->matched);
    best_log_evidence_ = std::max(best_log_evidence_, pose->log_evidence);
    result_.poses.push_back(*pose);
  }

  /// True when a verified pose is nearly the same.
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

  // ---- what need not be searched

  /// About one true triple in fifteen determines its pose too poorly to be found. Where false alarms can compete
  /// with the true pose this calls for one more.
  [[nodiscard]] int spareRounds() const
  {
    return best_matched_ > 0 && expectedFalsePoses(falseAlarmModel(), best_matched_) > kChanceCompetes ? 1 : 0;
  }

  [[nodiscard]] int leastMatches() const { return std::min(kLeastMatches, static_cast<int>(bearings_.size())); }

  /// Poses with fewer inliers need not be searched: their evidence together is negligible, or by chance alone there are
  /// more of them than could be verified.
  [[nodiscard]] int leastNeeded() const
  {
    if (best_matched_ == 0) return leastMatches();
    const auto matters = [this](int least)
    { return logEvidenceOfFewer(least) > best_log_evidence_ + std::log(kNegligible); };
    const auto most_false = static_cast<double>(kMostVerified);
    int least = best_matched_;
    while (least > leastMatches() && matters(least) && expectedFalsePoses(falseAlarmModel(), least - 1) < most_false)
      --least;
    return least;
  }

  /// Evidence of the poses with fewer than `least` inliers.
  [[nodiscard]] double logEvidenceOfFewer(int least) const
  {
    return log_evidence_below_[std::min(static_cast<std::size_t>(least), log_evidence_below_.size() - 1)];
  }

  [[nodiscard]] BearingFalseAlarmModel falseAlarmModel() const
  {
    const double triples = candidates_.meanPossible();
    const Scan& scan = scans_[static_cast<std::size_t>(bearings_.front().scan)];
    return {triples, static_cast<int>(bearings_.size()),
            chanceMatchProbability(options_.gate * meanStd(), std::max(0.0, inView(scan) - 3))};
  }

  [[nodiscard]] double meanStd() const
  {
    double sum = 0;
    for (const ScanBearing& r : bearings_) sum += r.std;
    return sum / static_cast<double>(bearings_.size());
  }

  /// Mean number of landmarks in view that a bearing may show.
  [[nodiscard]] double inView(const Scan& scan) const
  {
    const double range = rangeLimit(scan);
    return std::isfinite(range) ? mean_allowed_ * std::min(1.0, kPi * square(range) / mapArea()) : mean_allowed_;
  }

  void finish()
  {
    if (budget_.exhausted()) result_.finished = false;
    const int searched = std::max({floor_, complete_from_, static_cast<int>(bearings_.size()) - tolerated_});
    const double missed = result_.poses.empty() ? -kUnlimited : logEvidenceOfFewer(searched);
    if (!result_.poses.empty()) result_.expected_false = expectedFalsePoses(falseAlarmModel(), best_matched_);
    result_.work.tested += candidates_.work().tested;
    result_.work.rounds += candidates_.work().rounds;
    rankPoses(result_, options_, missed, searched);
    result_.unique = result_.unique && result_.finished;
  }

  const LandmarkIndex& map_;
  std::span<const Scan> scans_;
  const PoseSearchOptions& options_;
  std::vector<ScanBearing> bearings_;
  const BearingSearchTables& tables_;
  WorkBudget& budget_;
  WorkBudget proposing_;
  BearingCandidates candidates_;
  PoseSearchResult result_;
  std::vector<double> log_evidence_below_;  // by the number of matches
  double best_log_evidence_ = -kUnlimited;
  int best_matched_ = 0, floor_ = 0, tolerated_ = -1;
  int complete_from_ = 0;    // with so many matches every pose that was proposed has been verified
  bool overflowed_ = false;  // more proposals than can be kept: the lesser ones are lost
  double mean_allowed_ = 0;
};
}  // namespace

PoseSearchResult BearingSearch::search(std::span<const Scan> scans, const PoseSearchOptions& options) const
{
  const SearchInput input(scans, DirectionTable::kMaxBearings);
  std::vector<ScanBearing> bearings = gatherBearings(input.scans());
  if (const auto nothing = input.resultWithoutSearch(bearings.size(), 3, map_.size())) return *nothing;
  WorkBudget own;
  WorkBudget budget =
      WorkBudget::partOf(options.budget != nullptr ? *options.budget : own, mostSearchWork(map_.size()));
  PoseSearchOptions within = options;
  within.budget = &budget;
  PoseSearchResult result = SearchRun(map_, input.scans(), within, std::move(bearings), tables_, budget).run();
  input.restore(result);
  return result;
}
}  // namespace mrpt_ext
