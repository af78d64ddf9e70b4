#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// Operations of one search at most: two tenths of a second, and more in large maps, where a single round takes longer.
/// The usual work is a fifth of it.
[[nodiscard]] std::uint64_t mostSearchWork(std::size_t landmarks);
/// Of all searches of one step of a localizer together: in large maps less than a search by itself may take, as another
/// step follows.
[[nodiscard]] std::uint64_t mostStepWork(std::size_t landmarks);

/// Of the work, for proposals; the rest is for verifying them.
inline constexpr double kProposingShare = 0.8;
/// Bearings that a pose must match: every constellation matches three.
inline constexpr int kLeastMatches = 4;

/// What a search works on: scans with no more detections than it has use for.
class SearchInput
{
 public:
  /// Of a scan with more than `most` detections so many are searched, in all directions (even_choice.h); of more than
  /// kMostScans scans, so many, evenly chosen with the last among them. `scans` must outlive this object.
  SearchInput(std::span<const Scan> scans, std::size_t most);

  static constexpr std::size_t kMostScans = 40;

  [[nodiscard]] std::span<const Scan> scans() const { return cut_.empty() ? scans_ : std::span<const Scan>(cut_); }
  /// Why there is nothing to search: unusable scans, less than `least` of the `gathered` detections or landmarks, or
  /// no promise. Otherwise nothing.
  [[nodiscard]] std::optional<PoseSearchResult> resultWithoutSearch(std::size_t gathered, std::size_t least,
                                                                    std::size_t landmarks) const;
  /// False where so many detections were left out that those searched are hardly as many true ones as a pose needs:
  /// a landmark is detected once by a scan, so that of more detections than landmarks most are false.
  [[nodiscard]] bool isPromising(std::size_t landmarks) const;
  /// Refers the assignments of a result to all detections; those that were not searched are unmatched.
  void restore(PoseSearchResult& result) const;

 private:
  std::span<const Scan> scans_;
  bool usable_;
  std::vector<Scan> cut_;                // empty: nothing was left out
  std::vector<std::size_t> whole_size_;  // of each scan in `cut_`
  std::vector<std::size_t> original_;    // of each detection searched, counted over all scans
};
}  // namespace mrpt_ext
