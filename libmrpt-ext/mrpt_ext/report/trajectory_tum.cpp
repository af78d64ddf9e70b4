#include "mrpt_ext/report/trajectory_tum.h"

#include <optional>

#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/tum.h"

namespace mrpt_ext
{
void writeTrajectoryTum(const std::filesystem::path& folder, const MethodTrajectory& trajectory)
{
  const auto rows = [&trajectory](const TextSink& write)
  {
    std::optional<TimedPose> last;
    for (const PoseEstimate& point : trajectory.points)
    {
      if (last && last->time != point.time) write(tumRow(*last));
      last = TimedPose{point.time, point.pose.mean, point.heading_known};
    }
    if (last) write(tumRow(*last));
  };
  writeFileAtomically(folder / ("trajectory_" + trajectory.name + ".tum"), rows);
}
}  // namespace mrpt_ext
