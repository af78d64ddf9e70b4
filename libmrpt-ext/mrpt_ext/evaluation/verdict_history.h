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
  std::string reason;  ///< the one that held longest, numbers aside, as one of the later of its frames words it
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
  /// Reasons of a spell that differ in their numbers only. Each frame's holds until the next frame.
  struct Cause
  {
    std::string kind, wording;
    double held = 0;  // [s]
    std::size_t frames = 0;
  };
  void takeReason(const std::string& reason);
  void explainSpell();

  std::array<std::size_t, 3> frames_{};  // by verdict
  std::vector<VerdictSpell> spells_;
  std::vector<Cause> causes_;  // of the last spell, in order of appearance
  std::size_t current_ = 0;    // that of the last frame
};
}  // namespace mrpt_ext
