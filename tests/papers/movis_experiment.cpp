#include "movis_experiment.h"

#include <functional>

#include "paper_settings.h"

namespace mrpt_ext::papers
{
namespace
{
/// What a method says at a point (index).
using Method = std::function<std::optional<MovisAnswer>(std::size_t)>;

/// One visit by one method; its D of every point.
std::vector<double> visit(const MovisLattice& lattice, const Method& method, LatticeErrors& errors)
{
  errors.at_point.resize(lattice.places.size());
  Sample d, elsewhere, slope, ball_in_robot, ball_in_field, slip;
  for (std::size_t i = 0; i < lattice.places.size(); ++i)
  {
    const auto answer = method(i);
    if (!answer) continue;
    const Vector2d& place = lattice.places[i];
    d.add((answer->position - place).norm());
    errors.at_point[i].add(d.values().back());
    ball_in_robot.add((answer->ball_in_robot - (lattice.ball - place)).norm());
    ball_in_field.add((answer->ball_in_field - lattice.ball).norm());
    if (i == lattice.origin) continue;
    elsewhere.add(d.values().back());
    slope.add(std::abs(answer->slope));
    slip.add((answer->ball_in_field - answer->ball_in_robot - answer->position).norm());
  }
  errors.mean_d.add(d.mean());
  errors.median_d.add(d.median());
  errors.rms_d.add(d.rms());
  errors.mean_d_elsewhere.add(elsewhere.mean());
  errors.slope.add(slope.mean());
  errors.ball_in_robot.add(ball_in_robot.mean());
  errors.ball_in_field.add(ball_in_field.mean());
  errors.frame_slip.add(slip.mean());
  return d.values();
}

void visitByPaper(MovisExperiment& e, const std::vector<MovisLook>& looks)
{
  const OriginCorrection correction = paperCorrection(e.lattice, looks[e.lattice.origin]);
  const auto before = visit(
      e.lattice, [&](std::size_t i) { return paperAnswer(e.lattice, looks[i]); }, e.closed_form);
  const auto after = visit(
      e.lattice, [&](std::size_t i) { return paperAnswer(e.lattice, looks[i], correction); }, e.origin_corrected);
  for (std::size_t i = 0; i < e.worse.size() && before.size() == after.size() && i < after.size(); ++i)
    e.worse[i] += after[i] > before[i] ? 1 : 0;
  const auto lowered = [](Sample& share, const Sample& from, const Sample& to)
  { share.add(1 - to.values().back() / from.values().back()); };
  lowered(e.lower_mean, e.closed_form.mean_d, e.origin_corrected.mean_d);
  lowered(e.lower_mean_elsewhere, e.closed_form.mean_d_elsewhere, e.origin_corrected.mean_d_elsewhere);
  lowered(e.lower_median, e.closed_form.median_d, e.origin_corrected.median_d);
  lowered(e.lower_rms, e.closed_form.rms_d, e.origin_corrected.rms_d);
}

void visitByOurs(MovisExperiment& e, const std::vector<MovisLook>& looks, RandomStream& random)
{
  const MovisLattice& lattice = e.lattice;
  const auto yaw = calibratedYaw(lattice, {looks[lattice.origin]});
  const auto straight = [&](std::size_t i) { return straightened(looks[i], yaw); };
  visit(
      lattice, [&](std::size_t i) { return paperAnswer(lattice, straight(i)); }, e.straight_closed);
  visit(
      lattice, [&](std::size_t i) { return likeliestAnswer(lattice, looks[i]); }, e.likeliest);
  visit(
      lattice, [&](std::size_t i) { return likeliestAnswer(lattice, straight(i)); }, e.best);
  visit(
      lattice, [&](std::size_t i) { return likeliestAnswer(lattice, straight(i), true); }, e.best_told);
  visit(
      lattice, [&](std::size_t i) { return answerAtBound(lattice, lattice.places[i], false, random); }, e.bound);
  visit(
      lattice, [&](std::size_t i) { return answerAtBound(lattice, lattice.places[i], true, random); }, e.bound_told);
}
}  // namespace

MovisExperiment runMovisExperiment(const Settings& settings)
{
  MovisExperiment e;
  e.lattice = readLattice(settings);
  e.worse.resize(e.lattice.places.size());
  const int trials = trialsOf(settings);
  RandomStream random(seedOf(settings)), bound_random(seedOf(settings), 1);
  for (int trial = 0; trial < trials; ++trial)
  {
    std::vector<MovisLook> looks;
    for (const Vector2d& place : e.lattice.places) looks.push_back(lookFrom(e.lattice, place, random));
    visitByPaper(e, looks);
    visitByOurs(e, looks, bound_random);
  }
  for (double& share : e.worse) share /= trials;
  return e;
}
}  // namespace mrpt_ext::papers
