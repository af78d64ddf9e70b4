#pragma once

namespace mrpt_ext
{
/// How far an estimate can be trusted, judged from its own consistency, never from ground truth.
enum class Verdict
{
  ok,         ///< one precise mode, verified by the measurements
  ambiguous,  ///< several modes, one imprecise mode, or one that is not verified yet
  lost        ///< no estimate, or the recent detections do not agree with it: their inlier ratio is too low
};

[[nodiscard]] constexpr const char* toString(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::ok:
      return "ok";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::lost:
      return "lost";
  }
  return "unknown";
}
}  // namespace mrpt_ext
