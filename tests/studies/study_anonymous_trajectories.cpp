#include <filesystem>
#include <iomanip>

#include "mrclam_trajectories.h"
#include "shared_data.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
using namespace mrclam_trajectories;

constexpr double kBetweenStarts = 15;  // [s]

void print(std::ostream& out, int robot, const char* what, Tally t)
{
  const double n = std::max(1, t.enough), starts = std::max(1, t.starts);
  std::sort(t.ms.begin(), t.ms.end());
  const auto quantile = [&](double share)
  { return t.ms.empty() ? 0.0 : t.ms[static_cast<std::size_t>(share * static_cast<double>(t.ms.size() - 1))]; };
  out << "| " << robot << " | " << what << " | " << t.starts << " | " << std::fixed << std::setprecision(1)
      << 100 * t.within_30 / starts << " % | " << 100 * t.within_60 / starts << " % | " << 100 * t.enough / starts
      << " % | " << 100 * t.first / n << " % (" << t.first << " of " << t.enough << ") | " << 100 * t.among / n
      << " % | " << t.returned / n << " | " << t.seconds / n << " s | " << quantile(0.5) << " / " << quantile(0.95)
      << " |" << std::endl;
}

void run(std::ostream& out)
{
  const auto folder = sharedData("mrclam/MRCLAM_Dataset6");
  if (!folder)
  {
    out << "skipped: MRCLAM data set 6 is not there (LANDMARK_DATA_DIR)\n";
    return;
  }
  out << "From a start every " << kBetweenStarts << " s, the trajectory grows by " << kBetweenTries
      << " s until the pose is determined: the stated probability\nof the likeliest pose is above " << kEnough
      << ", or " << kLongest << " s have passed. Right: within " << kRightPosition << " m and "
      << radToDeg(kRightHeading) << " deg of the motion capture.\n\n"
      << "| robot | measured | starts | determined within 30 s | 60 s | " << kLongest
      << " s | of these right pose first | among the returned | returned | mean duration | one search, processor, "
         "median "
         "/ 95 "
         "[ms] "
         "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const bool ranges : {true, false})
    for (const int robot : mrclamRobots(*folder))
    {
      Recording recording = importMrclam(*folder, robot);
      hideIdentities(recording);
      if (!ranges) keepBearingsOnly(recording);
      print(out, robot, ranges ? "range and bearing" : "bearing", tallyTrajectories(recording, kBetweenStarts));
      out.flush();
    }
}

const RegisterStudy kStudy("anonymous_trajectories",
                           "MRCLAM 6 without identities: after which time does the trajectory determine the pose, and "
                           "is it right?",
                           run);
}  // namespace
}  // namespace mrpt_ext
