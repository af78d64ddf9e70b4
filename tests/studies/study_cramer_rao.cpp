#include <iomanip>

#include "cramer_rao_trials.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
using What = MeasurementSetup::What;

void againstBound(std::ostream& out, What what, const char* noise_title, double std_bearing_deg, double std_range,
                  const std::vector<double>& scales, int scenes, int trials, double extent)
{
  out << "| landmarks | " << noise_title
      << " | scenes below 5 % | RMSE / bound: median | 90 % | max | flagged of the others | flagged falsely | trials "
         "flagged falsely | ambiguous trials |\n|---|---|---|---|---|---|---|---|---|---|\n";
  IdentifiedPoseOptions options;
  options.extent = extent;
  if (extent > 0) options.max_relative_error = 0.045;  // the side is known: less margin is needed
  for (const int landmarks : {4, 6, 10, 30})
    for (const double scale : scales)
    {
      RandomStream random(1, static_cast<std::uint64_t>(landmarks * 100) + static_cast<std::uint64_t>(10 * scale));
      const MeasurementSetup setup{what, degToRad(scale * std_bearing_deg), scale * std_range};
      const CramerRaoTally t = tallyAgainstBound(setup, landmarks, scenes, trials, options, random);
      const int good = t.scenes - t.other_scenes;
      out << std::fixed << "| " << landmarks << " | " << std::setprecision(2);
      if (std_bearing_deg > 0) out << scale * std_bearing_deg << " deg ";
      if (std_range > 0) out << scale * std_range << " m ";
      out << "| " << good << " | " << std::setprecision(3) << t.quantile(0.5) << " | " << t.quantile(0.9) << " | "
          << t.quantile(1) << " | " << t.flagged_other << " of " << t.other_scenes << " | " << t.flagged_good << " of "
          << good << " | " << std::setprecision(2) << 100.0 * static_cast<double>(t.degenerate_good) / (good * trials)
          << " % | " << 100.0 * static_cast<double>(t.ambiguous) / static_cast<double>(t.trials) << " % |" << std::endl;
    }
  out << '\n';
}

void trust(std::ostream& out, const char* name, What what, double std_bearing_deg, double std_range, int scenes)
{
  TrustTally tally;
  RandomStream random(2, static_cast<std::uint64_t>(what));
  const std::array<int, 4> landmarks{4, 6, 10, 30};
  const std::array<double, 3> scales{0.1, 0.3, 1.0};
  for (int s = 0; s < scenes; ++s)
  {
    const Scene scene = randomScene(random, landmarks[static_cast<std::size_t>(s) % 4]);
    const double scale = scales[static_cast<std::size_t>(s) / 4 % 3];
    const MeasurementSetup setup{what, degToRad(scale * std_bearing_deg), scale * std_range};
    tallyTrust(tally, scene, solvePoseFromLandmarks(measureScene(scene, setup, random)));
  }
  const auto count = [&](SolveStatus status) { return tally.status[static_cast<std::size_t>(status)]; };
  out << "| " << name << " | " << scenes << " | " << count(SolveStatus::ok) << " | "
      << count(SolveStatus::ok) - tally.unique << " | " << count(SolveStatus::degenerate) << " | "
      << count(SolveStatus::none) << " | " << tally.far_off << " | " << tally.confident_wrong << " | "
      << std::setprecision(2) << tally.worst << " | " << tally.mean_nees << " |" << std::endl;
}

void run(std::ostream& out)
{
  const std::vector<double> scales{0.1, 0.3, 1.0};
  out << "Bearings; degenerate: bound above 4 % of the spread of landmarks and robot, or bent likelihood:\n\n";
  againstBound(out, What::bearings, "noise", 1, 0, scales, 500, 400, 0);
  out << "Bearings; degenerate: bound above 4.5 % of the side of the map, or bent likelihood:\n\n";
  againstBound(out, What::bearings, "noise", 1, 0, scales, 500, 400, 10);
  out << "Ranges:\n\n";
  againstBound(out, What::ranges, "noise", 0, 0.3, scales, 200, 200, 0);
  out << "Range and bearing of each landmark:\n\n";
  againstBound(out, What::ranges_and_bearings, "noise", 1, 0.3, scales, 200, 200, 0);
  out << "Bearings and ranges mixed, three sensors:\n\n";
  againstBound(out, What::mixed, "noise", 1, 0.3, scales, 200, 200, 0);
  out << "Trust in single answers (4, 6, 10 and 30 landmarks, three noises each; beyond 6 sigma: of the answer's own "
         "covariance):\n\n"
         "| measurements | scenes | ok | of which ambiguous | degenerate | none | further than the side | beyond 6 "
         "sigma | worst | mean squared error / covariance |\n|---|---|---|---|---|---|---|---|---|---|\n";
  trust(out, "bearings", What::bearings, 1, 0, 100000);
  trust(out, "ranges", What::ranges, 0, 0.3, 100000);
  trust(out, "range and bearing", What::ranges_and_bearings, 1, 0.3, 100000);
  trust(out, "mixed", What::mixed, 1, 0.3, 100000);
}

const RegisterStudy kStudy("cramer_rao",
                           "Does the pose from identified measurements reach the Cramer-Rao bound, and does its "
                           "status tell when it does not?",
                           run);
}  // namespace
}  // namespace mrpt_ext
