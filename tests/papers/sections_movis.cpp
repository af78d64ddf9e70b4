#include <cmath>

#include "printed_rows.h"
#include "sections.h"

namespace mrpt_ext::papers
{
namespace
{
using P = PrintedLattice;
constexpr double kCm = 0.01;
const double kDeg = degToRad(1);
const std::string kScenario = "tests/papers/paper-001-lattice.ini";

std::string visits(const MovisExperiment& e) { return std::to_string(e.closed_form.mean_d.count()) + " visits"; }

ResultRow rowOf(const MovisExperiment& e, const std::string& what, const std::string& paper,
                Sample LatticeErrors::*figure, const LatticeErrors& closed_form, double unit)
{
  ResultRow row{.what = what, .paper = paper};
  row.closed_form = (closed_form.*figure).text(1, unit);
  row.best = (e.best.*figure).text(1, unit);
  row.limit = (e.bound.*figure).text(1, unit);
  row.trials = visits(e);
  return row;
}

ResultRow judged(ResultRow row, const Sample& ours, double printed, const std::string& reason)
{
  row.outcome = withinTwoSpreads(ours, printed);
  if (row.outcome == Outcome::differs) row.reason = reason;
  return row;
}

ResultSection tableOne(const MovisExperiment& e)
{
  ResultSection s;
  s.title = "Paper 001, table 1: the object as the robot sees it";
  s.scenarios = {kScenario};
  s.paragraph =
      "The robot, put down straight on each of the thirteen lattice points, finds the object by the lines of sight of "
      "its two front cameras (eq 1-2). The same formulas with turned cameras err by the figure below; with the "
      "cameras straightened at one known pose what remains is noise. By the printed rows the object lay on the middle "
      "of "
      "the field, 3 m ahead of K. Each visit looks once at every point; ± is the standard deviation of single visits.";
  Sample printed;
  for (std::size_t i = 0; i < kPrintedPoints.size(); ++i)
    printed.add((inMetres(kPrintedPoints[i].object_in_robot) - e.lattice.ball + e.lattice.places[i]).norm());
  s.rows.push_back(judged(rowOf(e, "mean distance of the object from where it is [cm]",
                                fixedText(printed.mean() / kCm, 1), &LatticeErrors::ball_in_robot, e.closed_form, kCm),
                          e.closed_form.ball_in_robot, printed.mean(),
                          "the cameras that explain the poles do not explain the object"));
  return s;
}

ResultSection tableTwo(const MovisExperiment& e)
{
  const std::string reason = "the noise and the number of measurements per point are not printed";
  ResultSection s;
  s.title = "Paper 001, table 2: positions before the correction at the origin";
  s.scenarios = {kScenario};
  s.paragraph =
      "D is the distance between the position by eq 1-7 and the true one. With cameras straight and this noise the "
      "closed form would err by " +
      e.straight_closed.mean_d.text(1, kCm) +
      " cm; with the noise and the mounting errors of the scenario, which were fitted to these tables (see the "
      "section on the cameras), it errs as the paper printed; *reproduced* means within two standard deviations of a "
      "visit. Our best estimator takes the same azimuths, straightens the cameras by one look at the origin, and "
      "maximises the likelihood; that it is not zero is the weak heading: told that the robot stands straight, as it "
      "did, the error falls to " +
      e.best_told.mean_d.text(1, kCm) + " cm.";
  s.rows.push_back(
      judged(rowOf(e, "mean D [cm]", fixedText(P::kMeanBefore / kCm, 1), &LatticeErrors::mean_d, e.closed_form, kCm),
             e.closed_form.mean_d, P::kMeanBefore, reason));
  s.rows.push_back(judged(
      rowOf(e, "median D [cm]", fixedText(P::kMedianBefore / kCm, 0), &LatticeErrors::median_d, e.closed_form, kCm),
      e.closed_form.median_d, P::kMedianBefore, reason));
  return s;
}

ResultRow loweredRow(const std::string& what, double printed, const Sample& ours, const MovisExperiment& e)
{
  ResultRow row{.what = what, .paper = percent(printed, 1)};
  row.closed_form = ours.text(1, 0.01) + " %";
  row.trials = visits(e);
  return judged(row, ours, printed, "the noise and the number of measurements per point are not printed");
}

/// Mean share of the visits in which eq 8 makes a point worse, on one side of the field.
double shareWorse(const MovisExperiment& e, double side)
{
  Sample shares;
  for (std::size_t i = 0; i < e.worse.size(); ++i)
    if (e.lattice.places[i].x() * side > 0) shares.add(e.worse[i]);
  return shares.mean();
}

ResultSection tableThree(const MovisExperiment& e)
{
  const std::string reason = "the noise and the number of measurements per point are not printed";
  ResultSection s;
  s.title = "Paper 001, table 3: positions after the correction at the origin (eq 8)";
  s.scenarios = {kScenario};
  s.paragraph =
      "Eq 8 scales what is measured so that the origin K comes out right. It helps where the geometry is like that "
      "at the origin and harms elsewhere: in the paper it makes C, H and M worse, all on the right; here it does "
      "harm in " +
      percent(shareWorse(e, 1)) + " of the visits of a point on the right, in " + percent(shareWorse(e, -1)) +
      " of one on the left (table below), so such a print is a matter of chance, its side is not. The text speaks of "
      "about 50 %; its own tables give 23.6 % for the mean and 46.5 % for the median. Factors per axis cannot undo a "
      "turned camera; taking the angles themselves off (best estimator) brings the error to near the limit.";
  s.rows.push_back(judged(
      rowOf(e, "mean D [cm]", fixedText(P::kMeanAfter / kCm, 1), &LatticeErrors::mean_d, e.origin_corrected, kCm),
      e.origin_corrected.mean_d, P::kMeanAfter, reason));
  s.rows.push_back(judged(
      rowOf(e, "median D [cm]", fixedText(P::kMedianAfter / kCm, 0), &LatticeErrors::median_d, e.origin_corrected, kCm),
      e.origin_corrected.median_d, P::kMedianAfter, reason));
  s.rows.push_back(loweredRow("mean D lower by", 1 - P::kMeanAfter / P::kMeanBefore, e.lower_mean, e));
  s.rows.push_back(loweredRow("... without K", 0.178, e.lower_mean_elsewhere, e));
  s.rows.push_back(loweredRow("median D lower by", 1 - P::kMedianAfter / P::kMedianBefore, e.lower_median, e));
  s.rows.push_back(loweredRow("RMS D lower by", 1 - P::kRmsRatio, e.lower_rms, e));
  s.plain.push_back({"point", "eq 1-7 [cm]", "with eq 8 [cm]", "visits in which eq 8 makes it worse", "paper",
                     "our best [cm]", "limit [cm]"});
  for (std::size_t i = 0; i < e.lattice.names.size(); ++i)
  {
    const std::string& name = e.lattice.names[i];
    const bool worse = std::string(P::kWorseAt).find(name) != std::string::npos;
    s.plain.push_back({name, e.closed_form.at_point[i].text(1, kCm), e.origin_corrected.at_point[i].text(1, kCm),
                       percent(e.worse[i]), worse ? "worse" : (i == e.lattice.origin ? "0 by construction" : "better"),
                       e.best.at_point[i].text(1, kCm), e.bound.at_point[i].text(1, kCm)});
  }
  return s;
}

ResultSection tableFour(const MovisExperiment& e)
{
  ResultSection s;
  s.title = "Paper 001, table 4: the object in the field";
  s.scenarios = {kScenario};
  s.paragraph =
      "With the heading the paper assumes, table 4 would be table 1 plus table 3. It is not: ten of thirteen rows fit "
      "when the sum is turned by 2.5 to 11.8 degrees, the heading error that must have been in the data. In our "
      "simulation the same slip is there, but smaller: turned cameras that explain D explain only part of the printed "
      "heading errors; the section on what the robot measured shows where the rest comes from.";
  ResultRow slope = rowOf(e, "mean heading error outside K [deg]", fixedText(P::kHeadingDeg, 1), &LatticeErrors::slope,
                          e.origin_corrected, kDeg);
  s.rows.push_back(judged(slope, e.origin_corrected.slope, degToRad(P::kHeadingDeg),
                          "no turn of the cameras that explains tables 2 and 3 gives headings as wrong as that"));
  Sample slip, distance;
  for (std::size_t i = 0; i < kPrintedPoints.size(); ++i)
  {
    const PrintedPoint& row = kPrintedPoints[i];
    if (i != e.lattice.origin)
      slip.add((inMetres(row.object_in_field) - inMetres(row.object_in_robot) - inMetres(row.after)).norm());
    distance.add((inMetres(row.object_in_field) - e.lattice.ball).norm());
  }
  s.rows.push_back(judged(rowOf(e, "distance of table 4 from table 1 + table 3 [cm]", fixedText(slip.mean() / kCm, 1),
                                &LatticeErrors::frame_slip, e.origin_corrected, kCm),
                          e.origin_corrected.frame_slip, slip.mean(), "headings are as wrong as the row above says"));
  s.rows.push_back(
      judged(rowOf(e, "mean distance of the object from where it is [cm]", fixedText(distance.mean() / kCm, 1),
                   &LatticeErrors::ball_in_field, e.origin_corrected, kCm),
             e.origin_corrected.ball_in_field, distance.mean(), "the headings are more wrong"));
  return s;
}

PlainRow scanRow(const YawTry& t)
{
  return {fixedText(t.std_bearing / kDeg, 2),
          fixedText(t.yaw[0] / kDeg, 2) + ", " + fixedText(t.yaw[1] / kDeg, 2),
          t.mean_before.text(1, kCm) + ", " + t.mean_after.text(1, kCm),
          t.median_before.text(1, kCm) + ", " + t.median_after.text(1, kCm),
          t.rms_ratio.text(2),
          percent(t.agreement),
          t.slope_after.text(1, kDeg)};
}

ResultSection cameras(const std::vector<YawTry>& scan)
{
  ResultSection s;
  s.title = "Paper 001: which cameras explain the tables";
  s.scenarios = {kScenario};
  const auto count = [&](auto holds) { return std::to_string(std::count_if(scan.begin(), scan.end(), holds)); };
  s.paragraph =
      "The paper gives neither the noise of an azimuth nor how well the cameras sat on their mounts. We tried " +
      std::to_string(scan.size()) + " combinations of noise and mounting errors; for " +
      count([](const YawTry& t) { return t.explains; }) +
      " of them all five printed figures of D (means and medians of tables 2 and 3, ratio of their RMS) lie within "
      "what 90 % of the visits give, and for " +
      count([](const YawTry& t) { return t.explains && t.explainsHeading(); }) +
      " of these the heading errors too. Cameras turned by some tenths of a degree are enough for what was printed of "
      "D, but the tables do not tell by how much each was; both turned alike look the same as a robot put down askew. "
      "The scenario uses the best one with cameras turned by at most half a degree, as may happen on a mount (first "
      "row); the best of all follow.";
  s.plain.push_back({"noise [deg]", "M1, M2 turned by [deg]", "mean D before, after [cm]", "median before, after [cm]",
                     "RMS after / before", "points as printed", "heading error [deg]"});
  s.plain.push_back({"paper", "", "46.6, 35.6", "43, 23", "0.91", "", "7.4"});
  if (const YawTry* likely = likeliestMount(scan)) s.plain.push_back(scanRow(*likely));
  for (std::size_t i = 0; i < std::min<std::size_t>(scan.size(), 6); ++i) s.plain.push_back(scanRow(scan[i]));
  return s;
}

ResultSection methods(const MovisExperiment& e, const DriveErrors& drive, const DriveErrors& turned)
{
  ResultSection s;
  s.title = "Paper 001: the same measurements, other estimators";
  s.scenarios = {kScenario, "tests/papers/paper-001-drive.ini", "tests/papers/paper-001-drive-turned.ini",
                 "ini/landmark-simulator/movis-lattice.ini", "ini/landmark-localization/movis-lattice.ini"};
  s.paragraph =
      "What each step brings, mean D over the lattice. The calibration of the cameras' angles uses the same single "
      "look at the origin that eq 8 uses. The filter knows no calibration at all: it drives along the lattice from an "
      "unknown start and finds the angles on the way; its error is the mean over the last two thirds of the drives. "
      "With angles of more than two degrees, which would explain the tables as well, it does not always find them "
      "(last row). Its limit is the posterior Cramer-Rao bound (RMSE), of cameras that sit straight.";
  const auto row = [&](const std::string& name, const LatticeErrors& errors, const LatticeErrors& bound)
  {
    s.plain.push_back({name, errors.mean_d.text(1, kCm), errors.slope.text(2, kDeg), bound.mean_d.text(1, kCm),
                       std::to_string(errors.mean_d.count()) + " visits"});
  };
  s.plain.push_back({"estimator", "mean D [cm]", "mean heading error [deg]", "limit [cm]", "N"});
  row("eq 1-7", e.closed_form, e.bound);
  row("eq 1-7 and eq 8", e.origin_corrected, e.bound);
  row("eq 1-7, cameras straightened", e.straight_closed, e.bound);
  row("maximum likelihood", e.likeliest, e.bound);
  row("maximum likelihood, cameras straightened", e.best, e.bound);
  row("... told that the robot stands straight", e.best_told, e.bound_told);
  const auto drive_row = [&](const std::string& name, const DriveErrors& errors)
  {
    s.plain.push_back({name, errors.distance.text(1, kCm) + "; RMSE " + fixedText(errors.rmse.rms() / kCm, 2),
                       errors.heading.text(2, kDeg), "RMSE " + fixedText(errors.bound.rms() / kCm, 2),
                       std::to_string(errors.distance.count()) + " drives, " + std::to_string(errors.lost) + " lost"});
  };
  drive_row("particle filter on a drive, cameras' angles unknown", drive);
  drive_row("... cameras turned by more than two degrees", turned);
  return s;
}
}  // namespace

Outcome withinTwoSpreads(const Sample& ours, double printed)
{
  return std::abs(ours.mean() - printed) <= 2 * ours.spread() ? Outcome::reproduced : Outcome::differs;
}

std::vector<ResultSection> sectionsMovis(const MovisExperiment& movis, const std::vector<YawTry>& scan,
                                         const DriveErrors& drive, const DriveErrors& turned_drive)
{
  return {tableOne(movis),  tableTwo(movis), tableThree(movis),
          tableFour(movis), cameras(scan),   methods(movis, drive, turned_drive)};
}
}  // namespace mrpt_ext::papers
