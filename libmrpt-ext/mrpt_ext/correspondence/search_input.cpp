#include "mrpt_ext/correspondence/search_input.h"

#include <algorithm>

#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/geometry/even_choice.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kOfSearch = 150'000'000, kOfSearchPerLandmark = 60'000;
constexpr std::uint64_t kOfStep = 300'000'000, kOfStepPerLandmark = 40'000;
}  // namespace

std::uint64_t mostSearchWork(std::size_t landmarks) { return kOfSearch + kOfSearchPerLandmark * landmarks; }

std::uint64_t mostStepWork(std::size_t landmarks) { return std::max(kOfStep, kOfStepPerLandmark * landmarks); }

SearchInput::SearchInput(std::span<const Scan> scans, std::size_t most) : scans_(scans), usable_(areUsable(scans))
{
  const bool all =
      scans.size() <= kMostScans &&
      std::all_of(scans.begin(), scans.end(), [&](const Scan& scan) { return scan.detections.size() <= most; });
  if (all || !usable_) return;
  const std::size_t kept = std::min(scans.size(), kMostScans);
  std::size_t first = 0;  // detection of the present scan
  for (std::size_t s = 0, next = 0; s < scans.size(); first += scans[s++].detections.size())
  {
    if (s + 1 != (next + 1) * scans.size() / kept) continue;
    ++next;
    const std::span<const AnonymousDetection> detections = scans[s].detections;
    Scan& cut = cut_.emplace_back(Scan{scans[s].T_robot_sensor, scans[s].model, {}});
    whole_size_.push_back(std::max<std::size_t>(1, detections.size()));
    if (detections.size() > most) cut.model.detection_probability.reset();  // what was left out is not missed
    for (const std::size_t d : evenChoice(detections, most))
    {
      cut.detections.push_back(detections[d]);
      original_.push_back(first + d);
    }
  }
}

std::optional<PoseSearchResult> SearchInput::resultWithoutSearch(std::size_t gathered, std::size_t least,
                                                                 std::size_t landmarks) const
{
  PoseSearchResult nothing;
  if (!usable_) nothing.status = SolveStatus::bad_input;
  if (!usable_ || gathered < least) return nothing;
  nothing.status = SolveStatus::none;
  nothing.finished = landmarks < least || isPromising(landmarks);
  if (landmarks >= least && nothing.finished) return std::nullopt;
  return nothing;
}

bool SearchInput::isPromising(std::size_t landmarks) const
{
  if (cut_.empty()) return true;
  double most = 0;  // true detections searched, of one scan
  for (std::size_t s = 0; s < cut_.size(); ++s)
    most = std::max(most, static_cast<double>(cut_[s].detections.size()) *
                              std::min(1.0, static_cast<double>(landmarks) / static_cast<double>(whole_size_[s])));
  return most >= kLeastMatches;
}

void SearchInput::restore(PoseSearchResult& result) const
{
  if (cut_.empty()) return;
  const std::size_t count = detectionCount(scans_);
  for (ConsistentPose& pose : result.poses)
  {
    std::vector<int> whole(count, -1);
    for (std::size_t d = 0; d < original_.size(); ++d) whole[original_[d]] = pose.assignment[d];
    pose.assignment = std::move(whole);
  }
}
}  // namespace mrpt_ext
