#include "mrpt_ext/calibration/range_bias_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_range_bias_calibration
{
namespace
{
const std::vector<Vector2d> kPlaces{{0, 0}, {7, 0.3}, {6.5, 6}, {0.2, 5.5}, {3.4, 6.2}};
const std::vector<Vector2d> kOffsets{{-0.1, -0.2}, {-0.1, 0.2}, {0.25, 0.1}};
const std::vector<double> kSensorBiases{0.20, 0.15, 0.17}, kLandmarkBiases{-0.06, 0.05, 0.08, -0.09, 0.02};
constexpr double kHeight = 0.6, kStd = 0.03;

RadioEpoch epochAt(const Pose2& pose, RandomStream& random)
{
  RadioEpoch epoch;
  for (std::size_t i = 0; i < kOffsets.size(); ++i)
    for (std::size_t j = 0; j < kPlaces.size(); ++j)
    {
      const double flat = predictRange(pose, kPlaces[j], {kOffsets[i].x(), kOffsets[i].y(), 0});
      const double error = kSensorBiases[i] + kLandmarkBiases[j] + kStd * random.gaussian();
      epoch.push_back({i, j, kPlaces[j], kOffsets[i], kHeight, std::hypot(flat, kHeight) + error});
    }
  return epoch;
}

std::vector<RadioEpoch> epochs(std::size_t count)
{
  RandomStream random(3, 0);
  std::vector<RadioEpoch> all;
  for (std::size_t k = 0; k < count; ++k)
    all.push_back(epochAt({random.uniform(1, 6), random.uniform(1, 5), random.uniform(-kPi, kPi)}, random));
  return all;
}
}  // namespace

TEST(RangeBiases, AreToldByRangesFromManyPlaces)
{
  std::vector<RadioEpoch> all = epochs(150);
  for (std::size_t k = 0; k < all.size(); k += 5) all[k][1].range += 1.5;  // one echo in 75 ranges, all of landmark 1
  const RangeBiases biases = estimateRangeBiases(all, 0.1);
  ASSERT_EQ(biases.status, SolveStatus::ok);
  EXPECT_EQ(biases.epochs, 150U);
  for (std::size_t i = 0; i < kSensorBiases.size(); ++i)
  {
    EXPECT_NEAR(biases.sensor[i], kSensorBiases[i], 5 * biases.std_sensor[i]);
    EXPECT_LT(biases.std_sensor[i], 0.01);
  }
  double sum = 0;
  for (std::size_t j = 0; j < kLandmarkBiases.size(); ++j)
  {
    EXPECT_NEAR(biases.landmark[j], kLandmarkBiases[j], 5 * biases.std_landmark[j] + 0.003);
    EXPECT_LT(biases.std_landmark[j], 0.01);
    sum += biases.landmark[j];
  }
  EXPECT_NEAR(sum, 0, 1e-9);
  EXPECT_NEAR(biases.scatter, kStd, 0.2 * kStd);
  EXPECT_GT(biases.outlier_share[1], 0.05);
  EXPECT_LT(biases.outlier_share[0], 0.02);
}

TEST(RangeBiases, OfAStandstillAreHardlyTold)
{
  RandomStream random(4, 0);
  std::vector<RadioEpoch> all;
  for (int k = 0; k < 50; ++k) all.push_back(epochAt({3, 2, 0.4}, random));
  const RangeBiases still = estimateRangeBiases(all, 0.1), moving = estimateRangeBiases(epochs(50), 0.1);
  ASSERT_EQ(moving.status, SolveStatus::ok);
  if (still.status == SolveStatus::ok)
  {
    EXPECT_GT(still.std_landmark[0], 3 * moving.std_landmark[0]);
  }
  else
  {
    EXPECT_EQ(still.status, SolveStatus::degenerate);
  }
}

TEST(RangeBiases, NeedManyMomentsWithSeveralSensors)
{
  EXPECT_EQ(estimateRangeBiases({}, 0.1).status, SolveStatus::too_few);
  EXPECT_EQ(estimateRangeBiases(epochs(9), 0.1).status, SolveStatus::too_few);
  std::vector<RadioEpoch> one_sensor = epochs(30);
  for (RadioEpoch& epoch : one_sensor) std::erase_if(epoch, [](const RadioRange& r) { return r.sensor > 0; });
  EXPECT_EQ(estimateRangeBiases(one_sensor, 0.1).status, SolveStatus::too_few);
}

TEST(RangeBiases, BadInputIsAStatus)
{
  std::vector<RadioEpoch> all = epochs(20);
  EXPECT_EQ(estimateRangeBiases(all, 0).status, SolveStatus::bad_input);
  all[3][2].range = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(estimateRangeBiases(all, 0.1).status, SolveStatus::bad_input);
}
}  // namespace mrpt_ext::test_range_bias_calibration
