#include "mrpt_ext/diagnosis/link_noise.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_link_noise
{
namespace
{
constexpr double kPeriod = 0.05, kTurnRate = 0.7, kSpeed = 0.4;  // [s], [rad/s], [m/s]

/// An arc of four seconds; `error(k)` [rad] is added to the turn of step k.
template <typename Error>
OdometryPath arc(Error&& error)
{
  std::vector<OdometryRecord> records{{0, {}}};
  for (int k = 0; k < 80; ++k)
    records.push_back({records.back().time + kPeriod,
                       compose(records.back().pose, {kSpeed * kPeriod, 0, kTurnRate * kPeriod + error(k)})});
  return OdometryPath(records, {});
}
}  // namespace

TEST(LinkNoise, OfAnEvenArcIsThatOfItsMotion)
{
  const OdometryPath path = arc([](int) { return 0; });
  const MotionModel model;
  for (const double lasts : {0.2, 0.7, 1.3})
  {
    const Matrix3d measured = incrementCovariance(model, path.between(1.4, 1.4 + lasts));
    const Matrix3d covariance = scattered(LinkNoise(model, path).covariances(1.4, 1.4 + lasts));
    EXPECT_LT((covariance - measured).norm(), 0.04 * measured.norm()) << lasts << "\n"
                                                                      << covariance << "\n"
                                                                      << measured;
  }
}

TEST(LinkNoise, DoesNotDependOnTheTurnMeasured)
{
  const MotionModel model;
  const auto variance = [&](double error)
  {
    const OdometryPath path = arc([&](int k) { return k >= 38 && k < 42 ? error : 0; });
    return scattered(LinkNoise(model, path).covariances(38 * kPeriod, 42 * kPeriod))(2, 2);
  };
  EXPECT_NEAR(variance(0.02), variance(0), 1e-9);
  EXPECT_NEAR(variance(-0.02), variance(0), 1e-9);
}

// The mean of measured turns by their weights is that of the true ones.
TEST(LinkNoise, WeighsTurnsMeasuredTooLongAndTooShortAlike)
{
  RandomStream random(5);
  const MotionModel model{.std_phi_per_deg = 0.6};
  double weighted = 0, weights = 0;
  for (int run = 0; run < 2000; ++run)
  {
    const double std = degToRad(0.6) * std::sqrt(radToDeg(kTurnRate * kPeriod));
    const OdometryPath path = arc([&](int) { return std * random.gaussian(); });
    const double weight = 1 / scattered(LinkNoise(model, path).covariances(38 * kPeriod, 42 * kPeriod))(2, 2);
    weighted += weight * path.between(38 * kPeriod, 42 * kPeriod).increment.phi;
    weights += weight;
  }
  EXPECT_NEAR(weighted / weights / (4 * kTurnRate * kPeriod), 1, 0.015);
}
}  // namespace mrpt_ext::test_link_noise
