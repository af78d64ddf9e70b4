#include "mrpt_ext/correspondence/local_map/track_association.h"

#include <algorithm>
#include <queue>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxGap = 4;  // scans between the first two detections
// Operations of predicting a track in a scan, and of comparing it with a detection there.
constexpr std::uint64_t kCostOfTrack = 2500, kCostOfFitting = 40;

struct Candidate
{
  LandmarkTrack track;
  double evidence = 0;
  std::size_t born = 0;  // equal evidence: the earlier one
  bool operator<(const Candidate& other) const
  {
    return evidence != other.evidence ? evidence < other.evidence : born > other.born;
  }
};

class TrackSearch
{
 public:
  TrackSearch(std::span<const PastScan> scans, WorkBudget& budget) : scans_(scans), budget_(budget)
  {
    for (const PastScan& p : scans) taken_.emplace_back(p.scan.detections.size(), false);
  }

  std::vector<LandmarkTrack> run()
  {
    for (std::size_t at = 0; at < scans_.size(); ++at)
      for (std::size_t d = 0; d < detectionsOf(at).size(); ++d) startFrom({at, d});
    std::vector<LandmarkTrack> tracks;
    while (!candidates_.empty())
    {
      Candidate best = candidates_.top();
      candidates_.pop();
      const std::size_t before = best.track.members.size();
      std::erase_if(best.track.members, [&](const auto& m) { return taken_[m.scan][m.detection]; });
      if (best.track.members.size() < before)
      {
        offer(std::move(best.track));
        continue;
      }
      for (const LandmarkTrack::Member& m : best.track.members) taken_[m.scan][m.detection] = true;
      tracks.push_back(std::move(best.track));
    }
    return tracks;
  }

 private:
  [[nodiscard]] const std::vector<AnonymousDetection>& detectionsOf(std::size_t scan) const
  {
    return scans_[scan].scan.detections;
  }

  /// Counts the comparison of a track with the detections of a scan.
  [[nodiscard]] bool mayCompareIn(std::size_t scan)
  {
    return budget_.spend(kCostOfTrack + kCostOfFitting * detectionsOf(scan).size());
  }

  void startFrom(const LandmarkTrack::Member& first)
  {
    const AnonymousDetection& d = detectionsOf(first.scan)[first.detection];
    if (!d.bearing) return;
    const LandmarkTrack single{.category = d.category, .members = {first}};
    if (d.range) return grow({d.category, {first}, {}, true});
    const std::size_t end = std::min(scans_.size(), first.scan + 1 + kMaxGap);
    for (std::size_t at = first.scan + 1; at < end && mayCompareIn(at); ++at)
    {
      const TrackPrediction expected = predictTrack(single, scans_, at);
      for (std::size_t k = 0; k < detectionsOf(at).size(); ++k)
        if (fitsWell(expected, d.category, at, k)) grow({d.category, {first, {at, k}}, {}, true});
    }
  }

  [[nodiscard]] std::optional<double> fitsWell(const TrackPrediction& expected, int category, std::size_t at,
                                               std::size_t detection) const
  {
    const AnonymousDetection& d = detectionsOf(at)[detection];
    if (!d.bearing || d.category != category) return std::nullopt;
    const TrackFit fit = compare(expected, scans_[at], d);
    if (fit.chi2 > square(kTrackGate) * fit.values) return std::nullopt;
    return fit.chi2 / fit.values;
  }

  void grow(LandmarkTrack track)
  {
    for (std::size_t at = track.members.back().scan + 1; at < scans_.size(); ++at)
    {
      if (!mayCompareIn(at)) return;
      const TrackPrediction expected = predictTrack(track, scans_, at);
      if (!expected.depth_known) return;  // parallel, or parting
      std::optional<std::size_t> closest;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < detectionsOf(at).size(); ++k)
        if (const auto score = fitsWell(expected, track.category, at, k); score && *score < least)
        {
          least = *score;
          closest = k;
        }
      if (closest) track.members.push_back({at, *closest});
    }
    offer(std::move(track));
  }

  void offer(LandmarkTrack track)
  {
    constexpr double kWorth = 9;  // of a detection, in units of chi2, against a false one
    const bool has_range =
        std::any_of(track.members.begin(), track.members.end(),
                    [&](const auto& m) { return detectionsOf(m.scan)[m.detection].range.has_value(); });
    if (track.members.empty() || (!has_range && track.members.size() < leastBearings(scans_.size()))) return;
    const WindowLandmark found = locateLandmark(observationsOf(track, scans_, Matrix3d::Zero()));
    if (found.status != SolveStatus::ok || found.candidates.size() != 1) return;
    track.point = found.candidates.front().in_robot;
    const double evidence = kWorth * static_cast<double>(track.members.size()) - found.candidates.front().chi2;
    candidates_.push({std::move(track), evidence, born_++});
  }

  std::span<const PastScan> scans_;
  WorkBudget& budget_;
  std::vector<std::vector<bool>> taken_;
  std::priority_queue<Candidate> candidates_;
  std::size_t born_ = 0;
};
}  // namespace

std::vector<LandmarkTrack> associateTracks(std::span<const PastScan> oldest_first, WorkBudget& budget)
{
  return TrackSearch(oldest_first, budget).run();
}
}  // namespace mrpt_ext
