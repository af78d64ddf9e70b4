#pragma once

namespace mrpt_ext
{
/// How sure a localizer is, judged from its own consistency, never from ground truth.
enum class Verdict
{
  ok,         ///< one place, sharp, and the measurements agree with it
  ambiguous,  ///< several places explain the measurements, or one that is not yet sharp
  lost        ///< no place explains the measurements better than chance
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
