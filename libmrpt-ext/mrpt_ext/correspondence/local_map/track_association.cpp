#include "mrpt_ext/correspondence/local_map/track_association.h"

#include <algorithm>
#include <queue>

namespace mrpt_ext
{
namespace
{
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
  TrackSearch(std::span<const PastScan> places, const TrackOptions& options) : places_(places), options_(options)
  {
    for (const PastScan& p : places) taken_.emplace_back(p.place.detections.size(), false);
  }

  std::vector<LandmarkTrack> run()
  {
    for (std::size_t at = 0; at < places_.size(); ++at)
      for (std::size_t d = 0; d < detectionsOf(at).size(); ++d) startFrom({at, d});
    std::vector<LandmarkTrack> tracks;
    while (!candidates_.empty())
    {
      Candidate best = candidates_.top();
      candidates_.pop();
      const std::size_t before = best.track.members.size();
      std::erase_if(best.track.members, [&](const auto& m) { return taken_[m.place][m.detection]; });
      if (best.track.members.size() < before)
      {
        offer(std::move(best.track));
        continue;
      }
      for (const LandmarkTrack::Member& m : best.track.members) taken_[m.place][m.detection] = true;
      tracks.push_back(std::move(best.track));
    }
    return tracks;
  }

 private:
  [[nodiscard]] const std::vector<AnonymousDetection>& detectionsOf(std::size_t place) const
  {
    return places_[place].place.detections;
  }

  void startFrom(const LandmarkTrack::Member& first)
  {
    const AnonymousDetection& d = detectionsOf(first.place)[first.detection];
    if (!d.bearing) return;
    const LandmarkTrack single{.kind = d.kind, .members = {first}};
    if (d.range) return grow({d.kind, {first}, {}, true});
    const std::size_t end = std::min(places_.size(), first.place + 1 + options_.max_gap);
    for (std::size_t at = first.place + 1; at < end; ++at)
    {
      const TrackPrediction expected = predictTrack(single, places_, at, options_.nearest);
      for (std::size_t k = 0; k < detectionsOf(at).size(); ++k)
        if (fitsWell(expected, d.kind, at, k)) grow({d.kind, {first, {at, k}}, {}, true});
    }
  }

  [[nodiscard]] std::optional<double> fitsWell(const TrackPrediction& expected, int kind, std::size_t at,
                                               std::size_t detection) const
  {
    const AnonymousDetection& d = detectionsOf(at)[detection];
    if (!d.bearing || d.kind != kind) return std::nullopt;
    const TrackFit fit = compare(expected, places_[at], d);
    if (fit.chi2 > square(options_.gate) * fit.values) return std::nullopt;
    return fit.chi2 / fit.values;
  }

  void grow(LandmarkTrack track)
  {
    for (std::size_t at = track.members.back().place + 1; at < places_.size(); ++at)
    {
      const TrackPrediction expected = predictTrack(track, places_, at, options_.nearest);
      if (!expected.depth_known) return;  // parallel, or parting
      std::optional<std::size_t> closest;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < detectionsOf(at).size(); ++k)
        if (const auto score = fitsWell(expected, track.kind, at, k); score && *score < least)
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
    constexpr double kWorth = 9;  // of a sighting, in units of chi2: what it saves against an unexplained one
    const bool has_range =
        std::any_of(track.members.begin(), track.members.end(),
                    [&](const auto& m) { return detectionsOf(m.place)[m.detection].range.has_value(); });
    if (track.members.empty() || (!has_range && track.members.size() < leastBearings(options_, places_.size()))) return;
    const WindowLandmark found = locateLandmark(sightingsOf(track, places_, Matrix3d::Zero()));
    if (found.status != SolveStatus::ok || found.places.size() != 1) return;
    track.point = found.places.front().in_robot;
    const double evidence = kWorth * static_cast<double>(track.members.size()) - found.places.front().chi2;
    candidates_.push({std::move(track), evidence, born_++});
  }

  std::span<const PastScan> places_;
  const TrackOptions& options_;
  std::vector<std::vector<bool>> taken_;
  std::priority_queue<Candidate> candidates_;
  std::size_t born_ = 0;
};
}  // namespace

std::vector<LandmarkTrack> associateTracks(std::span<const PastScan> oldest_first, const TrackOptions& options)
{
  return TrackSearch(oldest_first, options).run();
}
}  // namespace mrpt_ext
