#include "mrpt_ext/diagnosis/map_agreement.h"

#include <algorithm>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/min_inlier_ratio.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kEnoughFrames = 20;
}  // namespace

void MapAgreement::add(Verdict verdict, double inlier_ratio)
{
  ++frames_;
  ok_ += verdict == Verdict::ok ? 1 : 0;
  too_low_ += inlier_ratio < kMinInlierRatio ? 1 : 0;
  ratios_ += std::min(inlier_ratio, 1.0);
}

bool MapAgreement::neverAgreed() const { return frames_ >= kEnoughFrames && ok_ == 0 && 2 * too_low_ > frames_; }

std::string MapAgreement::hint(const LandmarkCheck& frames,
                               const std::map<std::string, LandmarkRecord>& landmarks) const
{
  const auto seen = std::count_if(landmarks.begin(), landmarks.end(), [](const auto& l) { return l.second.seen > 0; });
  if (frames_ >= kEnoughFrames && ok_ == 0 && seen == 1)
    return "all detections are of one landmark, which leaves the pose on a circle around it: more landmarks are "
           "needed, or a known start (init_PDF_mode = gaussian)";
  if (!neverAgreed()) return {};
  return "never `ok`: on average only " + fixedText(100 * ratios_ / static_cast<double>(frames_), 0) +
         " % of the detections that should agree with the map do so: " + frames.cause();
}
}  // namespace mrpt_ext
