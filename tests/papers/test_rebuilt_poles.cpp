#include <gtest/gtest.h>

#include "movis_methods.h"
#include "paper_settings.h"
#include "printed_rows.h"
#include "rebuilt_poles.h"

namespace mrpt_ext::papers::test_rebuilt_poles
{
namespace
{
struct Rebuilt
{
  MovisLattice lattice = readLattice(paperSettings("paper-001-lattice", {}));
  RebuiltLattice seen = rebuiltFromPrint(lattice);
};

double meanError(const Rebuilt& r, bool told)
{
  double sum = 0;
  for (std::size_t i = 0; i < r.seen.points.size(); ++i)
  {
    const auto answer = likeliestAnswer(r.lattice, r.seen.lookAt(r.lattice, i), told);
    EXPECT_TRUE(answer) << r.lattice.names[i];
    if (answer) sum += (answer->position - r.lattice.places[i]).norm();
  }
  return sum / static_cast<double>(r.seen.points.size());
}
}  // namespace

TEST(PaperRebuiltPoles, TablesTwoAndThreeComeOutOfThem)
{
  const Rebuilt r;
  for (std::size_t i = 0; i < r.seen.points.size(); ++i)
  {
    const MovisLook look = r.seen.lookAt(r.lattice, i);
    const auto before = paperAnswer(r.lattice, look), after = paperAnswer(r.lattice, look, r.seen.correction);
    ASSERT_TRUE(before && after) << r.lattice.names[i];
    const bool misprinted = std::string(kMisprintedAt).find(r.lattice.names[i]) != std::string::npos;
    EXPECT_LT((before->position - inMetres(kPrintedPoints[i].before)).norm(), misprinted ? 0.03 : 0.015)
        << r.lattice.names[i];
    EXPECT_LT((after->position - inMetres(kPrintedPoints[i].after)).norm(), 0.005) << r.lattice.names[i];
  }
}

TEST(PaperRebuiltPoles, AtTheOriginTheRobotSawBothPolesTurned)
{
  const Rebuilt r;
  const RebuiltPoint& origin = r.seen.points[r.lattice.origin];
  EXPECT_NEAR(radToDeg(turnOf(origin.p, r.lattice.poleP(), {0, 0})), 5, 1);
  EXPECT_NEAR(radToDeg(turnOf(origin.q, r.lattice.poleQ(), {0, 0})), 5, 1);
  EXPECT_NEAR(radToDeg(origin.slope_before), -6.5, 0.5);
  double before = 0, after = 0;
  for (const RebuiltPoint& point : r.seen.points)
    before += std::abs(point.slope_before) / 13, after += std::abs(point.slope_after) / 13;
  EXPECT_LT(radToDeg(before), 4.5);
  EXPECT_GT(radToDeg(after), 6.5);
}

TEST(PaperRebuiltPoles, KnowingThatTheRobotStandsStraightHelpsMost)
{
  const Rebuilt r;
  EXPECT_NEAR(meanError(r, false), 0.44, 0.04);
  EXPECT_LT(meanError(r, true), 0.18);
}
}  // namespace mrpt_ext::papers::test_rebuilt_poles
