#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "printed_formulas.h"
#include "proof.h"
#include "random_scene.h"

namespace mrpt_ext::papers
{
namespace
{
using printed::Complex;

/// Exact bearings of a random scene in which the pose is well determined.
struct Example
{
  std::vector<Vector2d> landmarks;
  std::vector<double> bearings;
  std::vector<KnownBearing> known;
  Pose2 robot;

  Example(RandomStream& random, int count)
  {
    for (double quality = 0; quality < 0.01;)
    {
      const Scene scene = randomScene(random, count);
      landmarks = scene.landmarks;
      robot = scene.robot;
      known = measureBearings(scene, random, 0, 1);
      quality = solveBearingPoseLinear(known).det_ratio;
    }
    for (const KnownBearing& k : known) bearings.push_back(k.bearing);
  }
  [[nodiscard]] Vector2d to(std::size_t i) const { return landmarks[i] - robot.position(); }
  /// (L_i - R) / (L_0 - R)
  [[nodiscard]] Complex ratio(std::size_t i) const { return printed::complex(to(i)) / printed::complex(to(0)); }
  [[nodiscard]] double range(std::size_t i) const { return to(i).norm() / to(0).norm(); }
};

Erratum equationOne()
{
  Proof proof;
  RandomStream random(1);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 5);
    const auto error = [&](double reference)
    { return (printed::bearingPosition(e.landmarks, e.bearings, reference) - e.robot.position()).norm(); };
    proof.add(error(e.robot.phi), error(e.bearings[0]));
  }
  return proof.erratum("000, eq 1", "bearings against theta_b, which is not defined (here read as the heading)",
                       "against theta_0, the bearing of the reference landmark", "position, square of 10 m [m]");
}

Erratum equationSix()
{
  Proof proof;
  RandomStream random(2);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 4);
    if (e.to(0).x() > 0) continue;  // half of all places
    const double heading = printed::bearingHeading(e.landmarks[0], e.robot.position(), e.bearings[0]);
    proof.add(radToDeg(std::abs(wrap(heading - e.robot.phi))),
              radToDeg(std::abs(wrap(solveBearingPoseLinear(e.known).pose.phi - e.robot.phi))));
  }
  return proof.erratum("000, eq 6", "tan^-1", "atan2, wrapped", "heading, landmark to the left [deg]");
}

Erratum equationEightSecondLine()
{
  Proof proof;
  RandomStream random(3);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 4);
    const auto error = [&](std::size_t angle)
    { return std::abs(std::polar(e.range(2), e.bearings[angle] - e.bearings[0]) - e.ratio(2)) / e.range(2); };
    proof.add(error(1), error(2));
  }
  return proof.erratum("000, eq 8, line 2", "theta_1", "theta_2", "(L_2 - R) / (L_0 - R), relative");
}

Erratum equationEightLastLine()
{
  Proof proof;
  RandomStream random(4);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 4);
    const auto error = [&](double range)
    { return std::abs(std::polar(range, e.bearings[3] - e.bearings[0]) - e.ratio(3)) / e.range(3); };
    proof.add(error(e.to(3).norm() / e.to(3).norm()), error(e.to(3).norm() / e.to(0).norm()));
  }
  return proof.erratum("000, eq 8, last line", "denominator abs(L_N - R)", "abs(L_0 - R)",
                       "(L_N - R) / (L_0 - R), relative");
}

Erratum equationEighteen()
{
  Proof proof;
  RandomStream random(5);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 4);
    const auto vector = [](const Complex& z) { return Vector2d(z.real(), z.imag()); };
    const auto a = [&](std::size_t i) {
      return vector(std::polar(1.0, e.bearings[i] - e.bearings[0]) / printed::complex(e.landmarks[i] - e.landmarks[0]));
    };
    const Vector2d f = vector(1.0 / printed::complex(e.to(0)));
    const Vector2d b = vector(1.0 / printed::complex(e.landmarks[1] - e.landmarks[0]));
    const auto error = [&](const Vector2d& other)
    { return std::abs(printed::rangeRatio(a(1), other, f, b) - e.range(1)) / e.range(1); };
    proof.add(error(a(2)), error(a(1)));
  }
  return proof.erratum("000, eq 18", "(a_1^T a), a without index (here read as a_2)", "(a_1^T a_1)", "r_1, relative");
}

Erratum numberOfLandmarks()
{
  Proof proof;
  RandomStream random(6);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 3);
    const BearingPoseLinear pose = solveBearingPoseLinear(e.known);
    const std::size_t solved_without_a_fourth = pose.status == SolveStatus::ok ? 1 : 0;
    proof.add(static_cast<double>(solved_without_a_fourth), (pose.pose.position() - e.robot.position()).norm());
  }
  return proof.erratum("000, sec 2 and 3", "more than three landmarks are needed", "three are enough",
                       "share of poses from three that the print denies; their position [m]");
}

Erratum listOfLandmarks()
{
  Proof proof;
  RandomStream random(7);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, 3);
    const std::vector<KnownBearing> as_printed{e.known[0], e.known[0], e.known[2]};
    const bool solved = solveBearingPoseLinear(as_printed).status == SolveStatus::ok;
    const BearingPoseLinear right = solveBearingPoseLinear(e.known);
    proof.add(solved ? 0 : 1, (right.pose.position() - e.robot.position()).norm());
  }
  return proof.erratum("000, sec 3, list", "L_0, L_0, L_N", "L_0, L_1, ..., L_N",
                       "share without a pose; position with the right list [m]");
}
}  // namespace

std::vector<Erratum> errataOfPaper000()
{
  return {equationOne(),      equationSix(),       equationEightSecondLine(), equationEightLastLine(),
          equationEighteen(), numberOfLandmarks(), listOfLandmarks()};
}
}  // namespace mrpt_ext::papers
