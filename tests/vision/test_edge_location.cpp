#include "mrpt_ext/vision/edge_location.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_edge_location
{
namespace
{
constexpr int kEdges = 24, kParts = 6;
constexpr double kPartNoise = 0.001;  ///< [rad] that every part states
const EdgeBlur kBlur{0.007, 1.05, 220};

EdgePart partAt(double radius, double azimuth)
{
  return {radius, wrap(azimuth), kPartNoise, 0, kBlur.smoothing, kMoreSmoothing * kBlur.smoothing};
}

RadialEdge edgeAt(double azimuth)
{
  RadialEdge edge;
  edge.azimuth = wrap(azimuth);
  edge.width = kBlur.widthAt(0.7);
  edge.polarity = 1;
  edge.contrast = edge.height = 50;
  edge.inner = 0.4, edge.outer = 0.97;
  return edge;
}

/// Edges all around, 15 degrees apart. Their parts scatter by `scatter` of what they state, each by itself.
std::vector<RadialEdge> located(double scatter, RandomStream& random)
{
  std::vector<RadialEdge> edges;
  for (int i = 0; i < kEdges; ++i)
  {
    RadialEdge edge = edgeAt(kTwoPi * i / kEdges);
    for (int k = 0; k < kParts; ++k)
      edge.parts.push_back(partAt(0.45 + 0.09 * k, edge.azimuth + scatter * kPartNoise * random.gaussian()));
    edges.push_back(edge);
  }
  locateByParts(edges, kBlur, 0, 0);
  return edges;
}

struct Consistency
{
  double std = 0, nees = 0;
};

Consistency consistencyOf(double scatter)
{
  constexpr int kImages = 20;
  RandomStream random(7);
  Consistency mean;
  for (int image = 0; image < kImages; ++image)
  {
    const auto edges = located(scatter, random);
    for (int i = 0; i < kEdges; ++i)
    {
      const RadialEdge& edge = edges[static_cast<std::size_t>(i)];
      mean.std += edge.std_azimuth / (kImages * kEdges);
      mean.nees += square(wrap(edge.azimuth - kTwoPi * i / kEdges) / edge.std_azimuth) / (kImages * kEdges);
    }
  }
  return mean;
}
}  // namespace

TEST(EdgeLocation, StatedDeviationsFollowTheScatterOfTheImagesParts)
{
  const Consistency less = consistencyOf(0.6), usual = consistencyOf(1), more = consistencyOf(2);
  EXPECT_LT(less.std, 0.8 * usual.std);
  EXPECT_GT(more.std, 1.8 * usual.std);
  for (const Consistency& consistency : {less, usual})
  {
    EXPECT_GT(consistency.nees, 0.2);
    EXPECT_LT(consistency.nees, 1.3);
  }
  EXPECT_LT(more.nees, 1.3);
}

TEST(EdgeLocation, OneBentEdgeSaysSo)
{
  RandomStream random(7);
  std::vector<RadialEdge> edges = located(1, random);
  const double usual = edges[0].std_azimuth;
  for (std::size_t k = 0; k < edges[0].parts.size(); ++k)
    edges[0].parts[k].azimuth = wrap((k % 2 == 0 ? 3 : -3) * kPartNoise);
  locateByParts(edges, kBlur, 0, 0);
  EXPECT_GT(edges[0].std_azimuth, 2 * usual);
  EXPECT_LT(edges[1].std_azimuth, 1.5 * usual);
}

TEST(EdgeLocation, PixelsAndTheFloorAreErrorsOfWholeEdges)
{
  const auto stdOf = [](double centre_std, double floor)
  {
    std::vector<RadialEdge> edges{edgeAt(0)};
    for (int k = 0; k < kParts; ++k)
    {
      edges[0].parts.push_back(partAt(0.45 + 0.09 * k, 0));
      edges[0].parts.back().std_azimuth = 1e-7;
    }
    locateByParts(edges, kBlur, centre_std, floor);
    return edges[0].std_azimuth;
  };
  const double exact = stdOf(0, 0);
  EXPECT_GT(exact * 0.7 * kBlur.radius, 0.015);  // pixels
  EXPECT_LT(exact * 0.7 * kBlur.radius, 0.05);
  EXPECT_NEAR(stdOf(0, 0.002), std::hypot(exact, 0.002), 1e-9);
  EXPECT_GT(stdOf(0.1, 0), 0.1 / kBlur.radius);
}

TEST(EdgeLocation, APartWithoutDriftIsNotMovedByItsNeighboursDrift)
{
  // Where more smoothing shows no peak, nothing is known of the drift; neighbours alone tell the move.
  std::vector<RadialEdge> edges{edgeAt(0), edgeAt(degToRad(1.3))};
  edges[1].polarity = -1;
  for (RadialEdge& edge : edges)
    for (int k = 0; k < kParts; ++k)
    {
      edge.parts.push_back(partAt(0.45 + 0.09 * k, edge.azimuth));
      edge.parts.back().soft_spacing = 0;
    }
  locateByParts(edges, kBlur, 0, 0);
  // Peaks of opposite polarity were pushed apart; both edges are nearer to each other, alike.
  EXPECT_GT(edges[0].azimuth, degToRad(0.01));
  EXPECT_NEAR(edges[0].azimuth, degToRad(1.3) - edges[1].azimuth, 1e-4);
}
}  // namespace mrpt_ext::test_edge_location
