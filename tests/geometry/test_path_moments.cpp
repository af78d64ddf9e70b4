#include "mrpt_ext/geometry/path_moments.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/concatenated_motion.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext::test_path_moments
{
namespace
{
constexpr double kSmall = 1e-6;

/// The end of a path of straight steps with a heading error error(k) in the middle of step k.
template <typename Error>
Vector3d endOf(const std::vector<PathPiece>& pieces, Error&& error)
{
  Pose2 pose;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    const Pose2& step = pieces[k].increment;
    pose = compose(pose, {0.5 * step.x, 0.5 * step.y, error(k)});
    pose = compose(pose, {0.5 * step.x, 0.5 * step.y, step.phi});
  }
  return pose.vector();
}

std::vector<PathPiece> samplePath()
{
  std::vector<PathPiece> pieces;
  for (int k = 0; k < 20; ++k)
    pieces.push_back(k < 8 ? PathPiece{{0, 0, 0.1}, 0, 0.1, 0.2} : PathPiece{{0.1, 0, -0.05}, 0.1, 0.05, 0.1});
  return pieces;
}

PathMoments momentsAlong(const std::vector<PathPiece>& pieces)
{
  PathMoments moments;
  Pose2 end;
  for (const PathPiece& piece : pieces)
  {
    append(moments, end, piece);
    end = compose(end, piece.increment);
  }
  return moments;
}
}  // namespace

TEST(PathMoments, AreTheDerivativesOfTheEndByHeadingErrors)
{
  const std::vector<PathPiece> pieces = samplePath();
  const PathMoments moments = momentsAlong(pieces);
  const auto slope = [&](auto&& weight)
  {
    const Vector3d ahead = endOf(pieces, [&](std::size_t k) { return kSmall * weight(pieces[k]); });
    const Vector3d behind = endOf(pieces, [&](std::size_t k) { return -kSmall * weight(pieces[k]); });
    return Vector3d((ahead - behind) / (2 * kSmall));
  };
  const double close = 1e-6;
  EXPECT_TRUE(moments.by_turn.isApprox(slope([](const PathPiece& p) { return p.increment.phi; }), close));
  EXPECT_TRUE(
      moments.by_arc.isApprox(slope([](const PathPiece& p) { return p.length > 0 ? p.increment.phi : 0.0; }), close));
  EXPECT_TRUE(moments.by_length.isApprox(slope([](const PathPiece& p) { return p.length; }), close));
  EXPECT_TRUE(moments.by_time.isApprox(slope([](const PathPiece& p) { return p.duration; }), close));
}

TEST(PathMoments, TellHowFarARobotComesThatGoesFurtherOnArcs)
{
  const std::vector<PathPiece> pieces = samplePath();
  Pose2 end, end_further;
  for (const PathPiece& piece : pieces)
  {
    Pose2 further = piece.increment;
    if (isArc(piece)) further.x += kSmall * piece.turned;  // a small chord: along the x axis
    end = compose(end, piece.increment);
    end_further = compose(end_further, further);
  }
  EXPECT_TRUE(momentsAlong(pieces).along_arcs.isApprox((end_further.position() - end.position()) / kSmall, 1e-6));
  EXPECT_EQ(momentsOf(PathPiece{{0, 0, 1}, 0, 1, 1}).along_arcs.norm(), 0) << "in place";
  EXPECT_LT(momentsOf(PathPiece{{-1, 0, 0.5}, 1, 0.5, 1}).along_arcs.x(), 0) << "backwards";
}

TEST(PathMoments, SquaresWeighHeadAndTailOfThePathAlike)
{
  // Two metres straight in one second: std_phi^2 / 3 across the chord, / 2 between that and the heading.
  const PathMoments one = momentsOf(PathPiece{{2, 0, 0}, 2, 0, 1});
  EXPECT_NEAR(one.time(1, 1), 4.0 / 3, 1e-12);
  EXPECT_NEAR(one.time(1, 2), 2.0 / 2, 1e-12);
  EXPECT_NEAR(one.length(2, 2), 2, 1e-12);
  EXPECT_EQ(one.turned.norm(), 0);
  const PathMoments two = momentsAlong({{{0.5, 0, 0}, 0.5, 0, 0.25}, {{1.5, 0, 0}, 1.5, 0, 0.75}});
  EXPECT_TRUE(two.time.isApprox(one.time, 1e-12));
  EXPECT_TRUE(two.length.isApprox(one.length, 1e-12));
  EXPECT_TRUE(two.by_length.isApprox(one.by_length, 1e-12));
}

TEST(PathMoments, OfTwoPathsInARowAreThoseOfOne)
{
  const std::vector<PathPiece> pieces = samplePath();
  const auto motionAlong = [](const std::vector<PathPiece>& part)
  {
    OdometryMotion motion{.moments = momentsAlong(part)};
    for (const PathPiece& piece : part)
    {
      motion.increment = compose(motion.increment, piece.increment);
      motion.path_length += piece.length;
      motion.turned += piece.turned;
      motion.duration += piece.duration;
    }
    return motion;
  };
  const OdometryMotion expected = motionAlong(pieces),
                       whole = concatenated(motionAlong({pieces.begin(), pieces.begin() + 11}),
                                            motionAlong({pieces.begin() + 11, pieces.end()}));
  EXPECT_LT((whole.increment.vector() - expected.increment.vector()).norm(), 1e-12);
  EXPECT_NEAR(whole.path_length, expected.path_length, 1e-12);
  EXPECT_NEAR(whole.turned, expected.turned, 1e-12);
  EXPECT_NEAR(whole.duration, expected.duration, 1e-12);
  for (const auto sum : {&PathMoments::by_turn, &PathMoments::by_arc, &PathMoments::by_length, &PathMoments::by_time})
    EXPECT_TRUE(((*whole.moments).*sum).isApprox((*expected.moments).*sum, 1e-9));
  for (const auto sum : {&PathMoments::turned, &PathMoments::length, &PathMoments::time})
    EXPECT_TRUE(((*whole.moments).*sum).isApprox((*expected.moments).*sum, 1e-9));
  EXPECT_TRUE(whole.moments->along_arcs.isApprox(expected.moments->along_arcs, 1e-9));
}

TEST(PathMoments, OfAPathAreThoseOfItsRecords)
{
  std::vector<OdometryRecord> records{{0, {1, 2, 0.3}}};
  const std::vector<PathPiece> pieces = samplePath();
  for (const PathPiece& piece : pieces)
    records.push_back({records.back().time + piece.duration, compose(records.back().pose, piece.increment)});
  const OdometryPath path(records, {});
  const OdometryMotion whole = path.between(records.front().time, records.back().time);
  ASSERT_TRUE(whole.moments);
  const PathMoments expected = momentsAlong(pieces);
  EXPECT_TRUE(whole.moments->by_arc.isApprox(expected.by_arc, 1e-9));
  EXPECT_TRUE(whole.moments->turned.isApprox(expected.turned, 1e-9));
  EXPECT_TRUE(whole.moments->time.isApprox(expected.time, 1e-9));

  const OdometryMotion inside = path.between(0.05, 0.15);
  EXPECT_FALSE(inside.moments) << "between two records all passes evenly";
  EXPECT_NEAR(momentsOf(inside).by_turn.z(), inside.increment.phi, 1e-12);
  EXPECT_FALSE(path.between(1, 0.2).moments);
}
}  // namespace mrpt_ext::test_path_moments
