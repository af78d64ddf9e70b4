#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
/// Frames in a row with the same verdict.
struct VerdictSpell
{
  double from = 0, to = 0;  ///< [s] stamps of the first and the last frame
  Verdict verdict = Verdict::lost;
  std::string reason;  ///< of the first frame
};

/// Shares of the frames with each verdict, in [0, 1]; of several trials their means. Absent without a frame.
struct VerdictShares
{
  std::optional<double> ok, ambiguous, lost;
};

/// The verdicts of a filter, frame by frame, as spells and shares.
class VerdictHistory
{
 public:
  /// The next frame, at `time` [s].
  void add(double time, Verdict verdict, const std::string& reason);
  [[nodiscard]] const std::vector<VerdictSpell>& spells() const { return spells_; }
  [[nodiscard]] VerdictShares shares() const;

 private:
  std::array<std::size_t, 3> frames_{};  // by verdict
  std::vector<VerdictSpell> spells_;
};
}  // namespace mrpt_ext
