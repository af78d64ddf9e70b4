#include "mrpt_ext/correspondence/bearing_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mrpt_ext/correspondence/bearing_reading.h"
#include "mrpt_ext/correspondence/expected_false_poses.h"
#include "mrpt_ext/correspondence/match_evidence.h"
#include "mrpt_ext/correspondence/pose_judge.h"
#include "mrpt_ext/correspondence/pose_tightening.h"
#include "mrpt_ext/correspondence/triple_cover.h"
#include "mrpt_ext/correspondence/triple_round.h"

namespace mrpt_ext
{
namespace
{
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kListMargin = 0.02;  // of the range limit
constexpr int kLeastMatches = 4;      // three bearings are explained by every constellation
constexpr std::size_t kJudgedAtOnce = 64;
constexpr std::size_t kCapacity = 500000;  // proposals of one round that are kept
constexpr std::size_t kMaxJudged = 5000;
constexpr double kLargestFreedom = 0.5;   // of the range: how far a pose to be judged may be off
constexpr double kChanceCompetes = 1e-3;  // expected false poses as good as the best
constexpr double kNegligible = 1e-3;      // evidence relative to the best pose's
constexpr double kAreaMargin = 0.5;       // [m] a triple's pose may lie outside though the refined one does not

double rangeLimit(const SensorPlace& place) { return place.model.max_range.value_or(kUnlimited); }

class SearchRun
{
 public:
  SearchRun(const LandmarkIndex& map, std::span<const SensorPlace> places, const PoseSearchOptions& options,
            std::vector<BearingReading> readings)
      : map_(map), places_(places), options_(options), readings_(std::move(readings))
  {
  }

  PoseSearch run(const BearingSearch& owner)
  {
    prepareViews(owner);
    const std::vector<double> allowed = landmarksAllowed();
    mean_allowed_ = std::accumulate(allowed.begin(), allowed.end(), 0.0) / static_cast<double>(allowed.size());
    const std::vector<ReadingTriple> candidates =
        tripleCandidates(readings_, {allowed, ranges(), mapArea(), chanceMatches().chance});
    const int usable = static_cast<int>(readings_.size());
    for (int misses = expectedMisses();;)
    {
      floor_ = std::max(leastMatches(), usable - misses);
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

  void prepareViews(const BearingSearch& owner)
  {
    for (std::size_t p = 0; p < places_.size(); ++p)
    {
      std::vector<BearingReading> own;
      for (const BearingReading& r : readings_)
        if (r.place == static_cast<int>(p)) own.push_back(r);
      tables_.emplace_back(own, options_.gate);
      lists_.push_back(own.empty() ? nullptr : owner.listsFor(rangeLimit(places_[p])));
    }
  }

  [[nodiscard]] double mapArea() const
  {
    const Vector2d extent = map_.high() - map_.low();
    return std::max(extent.prod(), 1e-3 * extent.squaredNorm() + 1e-9);
  }

  [[nodiscard]] std::vector<double> ranges() const
  {
    std::vector<double> result;
    for (const SensorPlace& place : places_) result.push_back(rangeLimit(place));
    return result;
  }

  [[nodiscard]] std::vector<double> landmarksAllowed() const
  {
    std::vector<double> of_kind(static_cast<std::size_t>(map_.kindCount()), 0);
    for (std::size_t l = 0; l < map_.size(); ++l) of_kind[static_cast<std::size_t>(map_.kind(l))] += 1;
    std::vector<double> allowed;
    for (const BearingReading& r : readings_)
      allowed.push_back(r.kind == kAnyKind ? static_cast<double>(map_.size())
                                           : of_kind[static_cast<std::size_t>(r.kind)]);
    return allowed;
  }

  // ---- rounds

  /// So many readings without a landmark are looked for at first, going by what the sensors declare.
  [[nodiscard]] int expectedMisses() const
  {
    double mean = 0;
    for (const BearingReading& r : readings_)
      mean += places_[static_cast<std::size_t>(r.place)].model.clutter_probability;
    return static_cast<int>(std::ceil(mean)) + 1;
  }

  /// Rounds until every pose that matters and explains `floor_` readings has been proposed.
  void searchDownTo(const std::vector<ReadingTriple>& candidates)
  {
    TripleCover cover(candidates);
    pool_.clear();
    const int usable = static_cast<int>(readings_.size());
    while (result_.finished && cover.tolerated() < usable - std::max(leastNeeded(), floor_) + spareRounds())
    {
      const std::optional<ReadingTriple> triple = cover.next();
      if (!triple) break;
      propose(*triple);
      judgeBest(kJudgedAtOnce);
    }
    tolerated_ = cover.tolerated();
    judgeBest(std::numeric_limits<std::size_t>::max());
  }

  void propose(const ReadingTriple& triple)
  {
    const int place = readings_[static_cast<std::size_t>(triple.reading[0])].place;
    TripleRound round;
    round.map = &map_;
    round.readings = readings_;
    round.triple = triple;
    round.views = viewsFrom(place, triple);
    round.max_range = rangeLimit(places_[static_cast<std::size_t>(place)]);
    round.gate = options_.gate;
    round.area = areaOfSensor(place);
    round.max_tested = options_.max_tested - std::min(options_.max_tested, result_.work.tested);
    const int floor = std::max(leastNeeded(), floor_);
    ProposalStore store(floor, kCapacity);
    const TripleRound::Work work = round.run(store);
    ++result_.work.rounds;
    result_.work.tested += work.tested;
    result_.finished = work.finished;
    possible_ += static_cast<double>(work.possible);
    overflowed_ = overflowed_ || store.floor() > floor;
    if (store.floor() > floor) floor_ = store.floor();
    merge(store.takeSorted(), place, round.views);
  }

  [[nodiscard]] std::vector<SieveView> viewsFrom(int place, const ReadingTriple& triple) const
  {
    const Pose2 T_tested_robot = inverse(places_[static_cast<std::size_t>(place)].T_robot_sensor);
    std::vector<SieveView> views;
    for (std::size_t p = 0; p < places_.size(); ++p)
      if (lists_[p])
      {
        SieveView& view = views.emplace_back();
        view.table = &tables_[p];
        view.lists = lists_[p].get();
        view.T_tested_sensor = compose(T_tested_robot, places_[p].T_robot_sensor);
        if (static_cast<int>(p) == place) view.used = bitsOf(place, triple);
      }
    return views;
  }

  /// Bits of a triple's readings in the table of their place.
  [[nodiscard]] std::uint32_t bitsOf(int place, const ReadingTriple& triple) const
  {
    std::uint32_t bits = 0;
    std::size_t position = 0;
    for (std::size_t r = 0; r < readings_.size(); ++r)
    {
      if (readings_[r].place != place) continue;
      const bool used =
          std::find(triple.reading.begin(), triple.reading.end(), static_cast<int>(r)) != triple.reading.end();
      if (used && position < ReadingTable::kMaxReadings) bits |= 1U << position;
      ++position;
    }
    return bits;
  }

  [[nodiscard]] std::optional<MapArea> areaOfSensor(int place) const
  {
    if (!options_.area) return std::nullopt;
    const double margin = kAreaMargin + places_[static_cast<std::size_t>(place)].T_robot_sensor.position().norm();
    return MapArea{options_.area->min - Vector2d::Constant(margin), options_.area->max + Vector2d::Constant(margin)};
  }

  // ---- judging

  void merge(const std::vector<PoseProposal>& proposals, int place, std::span<const SieveView> views)
  {
    const Pose2 T_sensor_robot = inverse(places_[static_cast<std::size_t>(place)].T_robot_sensor);
    const int least = leastNeeded();
    for (const PoseProposal& p : proposals)
    {
      const TightenedPose tight = tightenPose(p.sensor, views, options_.gate, least, scratch_);
      if (tight.explained < least || !isFixed(tight.sensor, place)) continue;
      const Matrix3d J = composeJacobianFirst(tight.sensor.mean, T_sensor_robot);
      const auto level = static_cast<std::size_t>(tight.explained);
      if (pool_.size() <= level) pool_.resize(level + 1);
      pool_[level].push_back({compose(tight.sensor.mean, T_sensor_robot), J * tight.sensor.covariance * J.transpose()});
    }
  }

  /// False for a pose that so much is free to move that everything in sight would explain its readings.
  [[nodiscard]] bool isFixed(const GaussianPose& sensor, int place) const
  {
    const double reach =
        std::min(rangeLimit(places_[static_cast<std::size_t>(place)]), (map_.high() - map_.low()).norm());
    return options_.gate * std::sqrt(sensor.covariance.topLeftCorner<2, 2>().trace()) < kLargestFreedom * reach;
  }

  /// Judges the proposals that explain most, as long as they can matter.
  void judgeBest(std::size_t count)
  {
    int least = leastNeeded();
    for (std::size_t level = pool_.size(); level-- > 0;)
    {
      std::vector<GaussianPose>& waiting = pool_[level];
      std::size_t next = 0;
      for (; next < waiting.size() && count > 0 && result_.finished && static_cast<int>(level) >= least; ++next)
        if (!isKnown(waiting[next]))
        {
          judge(waiting[next]);
          least = leastNeeded();
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
    const auto pose = judgePose(map_, places_, options_, robot, leastNeeded());
    if (!pose) return;
    best_matched_ = std::max(best_matched_, pose->matched);
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

  /// About one true triple in eight fixes its pose too weakly to come through. Where chance can compete with the truth
  /// that calls for one more.
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
    while (least > leastMatches() && evidenceBelow(least) > kNegligible) --least;
    return least;
  }

  /// Evidence relative to the best pose's that poses with fewer than `least` matches are expected to have together.
  [[nodiscard]] double evidenceBelow(int least) const
  {
    const ChanceMatches chance = chanceMatches();
    double evidence = 0;
    for (int m = least - 1; m >= 3; --m)
    {
      const double poses = expectedFalsePoses(chance, m) - expectedFalsePoses(chance, m + 1);
      evidence += poses * std::exp(-logEvidencePerMatch() * (best_matched_ - m));
    }
    return evidence;
  }

  [[nodiscard]] ChanceMatches chanceMatches() const
  {
    const double triples = possible_ / std::max(1, result_.work.rounds);
    const SensorPlace& place = places_[static_cast<std::size_t>(readings_.front().place)];
    return {triples, static_cast<int>(readings_.size()),
            chanceOfMatch(options_.gate * meanStd(), std::max(0.0, inView(place) - 3))};
  }

  [[nodiscard]] double meanStd() const
  {
    double sum = 0;
    for (const BearingReading& r : readings_) sum += r.std;
    return sum / static_cast<double>(readings_.size());
  }

  /// Mean number of landmarks in view that a reading may show.
  [[nodiscard]] double inView(const SensorPlace& place) const
  {
    const double range = rangeLimit(place);
    return std::isfinite(range) ? mean_allowed_ * std::min(1.0, kPi * square(range) / mapArea()) : mean_allowed_;
  }

  /// What a match adds to the log-likelihood, typically: it is explained, and not by chance.
  [[nodiscard]] double logEvidencePerMatch() const
  {
    const SensorPlace& place = places_[static_cast<std::size_t>(readings_.front().place)];
    const double clutter = std::max(place.model.clutter_probability, 1e-6);
    const double peak = 1 / (std::sqrt(kTwoPi) * meanStd());
    const double count = static_cast<double>(place.detections.size());
    const double p = std::min(place.model.detection_probability.value_or(0.5), 0.99);
    const double odds = place.model.detection_probability ? p / (1 - p) / count : 1 / std::max(1.0, inView(place));
    return std::log(1 + odds * peak * kTwoPi / clutter) - 0.5;
  }

  void finish()
  {
    const int searched = std::max(floor_, static_cast<int>(readings_.size()) - std::max(tolerated_, 0));
    double missed = -kUnlimited;
    if (!result_.poses.empty())
    {
      missed = logEvidenceBelow(map_, places_, areaOrMap(map_, options_.area), searched);
      result_.expected_false = expectedFalsePoses(chanceMatches(), best_matched_);
    }
    rankPoses(result_, options_, missed, searched);
    result_.unique = result_.unique && result_.finished;
  }

  const LandmarkIndex& map_;
  std::span<const SensorPlace> places_;
  const PoseSearchOptions& options_;
  std::vector<BearingReading> readings_;
  std::vector<ReadingTable> tables_;
  std::vector<std::shared_ptr<const VisibleLists>> lists_;
  std::vector<std::vector<GaussianPose>> pool_;  // waiting to be judged, by the number of readings explained
  SeenLandmarks scratch_;
  PoseSearch result_;
  int best_matched_ = 0, floor_ = 0, tolerated_ = -1;
  bool overflowed_ = false;  // more proposals than can be kept: the lesser ones are lost
  double possible_ = 0, mean_allowed_ = 0;
};
}  // namespace

PoseSearch BearingSearch::search(std::span<const SensorPlace> places, const PoseSearchOptions& options) const
{
  PoseSearch nothing;
  if (!areUsable(places)) nothing.status = SolveStatus::bad_input;
  std::vector<BearingReading> readings = gatherBearings(places);
  if (nothing.status == SolveStatus::bad_input || readings.size() < 3) return nothing;
  if (map_.size() < 3)
  {
    nothing.status = SolveStatus::none;
    return nothing;
  }
  return SearchRun(map_, places, options, std::move(readings)).run(*this);
}

std::shared_ptr<const VisibleLists> BearingSearch::listsFor(double max_range) const
{
  const std::scoped_lock lock(mutex_);
  for (const auto& lists : lists_)
    if (lists->maxRange() == max_range) return lists;
  const double margin = std::isfinite(max_range) ? kListMargin * max_range : 0;
  return lists_.emplace_back(std::make_shared<const VisibleLists>(map_, max_range, margin));
}
}  // namespace mrpt_ext
