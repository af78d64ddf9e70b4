#include "mrpt_ext/calibration/block_tridiagonal_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_block_tridiagonal_solver
{
namespace
{
constexpr std::size_t kPoses = 6;
constexpr Eigen::Index kShared = 2;

/// The same normal equations, full.
struct Full
{
  static constexpr Eigen::Index kSize = 3 * kPoses + kShared;
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(kSize, kSize);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(kSize);

  void add(const Eigen::RowVectorXd& row, double residual, double weight)
  {
    information += weight * row.transpose() * row;
    gradient += weight * residual * row.transpose();
  }
};

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, RandomStream& random)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.gaussian(); });
}
}  // namespace

TEST(PoseChainSystem, SolvesLikeTheFullSystem)
{
  RandomStream random(5);
  PoseChainSystem chain(kPoses, kShared);
  Full full;
  for (std::size_t k = 0; k < kPoses; ++k)
  {
    const auto at = 3 * static_cast<Eigen::Index>(k);
    for (int i = 0; i < 4; ++i)
    {
      const Eigen::RowVector3d own = randomMatrix(1, 3, random);
      const Eigen::RowVectorXd shared = randomMatrix(1, kShared, random);
      const double residual = random.gaussian(), weight = random.uniform(0.2, 2);
      chain.addReading(k, residual, own, shared, weight);
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(Full::kSize);
      row.segment<3>(at) = own;
      row.tail(kShared) = shared;
      full.add(row, residual, weight);
    }
    if (k + 1 == kPoses || k == 2) continue;  // two separate trajectories
    const Matrix3d own = randomMatrix(3, 3, random), next = randomMatrix(3, 3, random);
    const PoseChainSystem::SharedRows shared = randomMatrix(3, kShared, random);
    const Vector3d residual = randomMatrix(3, 1, random);
    chain.addLink(k, residual, own, next, shared, 0.7);
    for (int axis = 0; axis < 3; ++axis)
    {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(Full::kSize);
      row.segment<3>(at) = own.row(axis);
      row.segment<3>(at + 3) = next.row(axis);
      row.tail(kShared) = shared.row(axis);
      full.add(row, residual[axis], 0.7);
    }
  }
  chain.addPrior(0.3, Eigen::RowVectorXd::Unit(kShared, 1), 4);
  full.information(Full::kSize - 1, Full::kSize - 1) += 4;
  full.gradient[Full::kSize - 1] += 1.2;

  const std::optional<ChainSolution> solution = chain.solve();
  ASSERT_TRUE(solution);
  const Eigen::VectorXd expected = full.information.ldlt().solve(full.gradient);
  const Eigen::MatrixXd covariance = full.information.inverse();
  const Eigen::MatrixXd of_poses = full.information.topLeftCorner(3 * kPoses, 3 * kPoses).inverse();
  EXPECT_LT((solution->shared_step - expected.tail(kShared)).norm(), 1e-10);
  EXPECT_LT((solution->shared_information.inverse() - covariance.bottomRightCorner(kShared, kShared)).norm(), 1e-10);
  EXPECT_LT((solution->pull +
             covariance.topRightCorner(3 * kPoses, kShared) * covariance.bottomRightCorner(kShared, kShared).inverse())
                .norm(),
            1e-8);
  for (std::size_t k = 0; k < kPoses; ++k)
  {
    const auto at = 3 * static_cast<Eigen::Index>(k);
    EXPECT_LT((solution->steps[k] - expected.segment<3>(at)).norm(), 1e-10);
    EXPECT_LT((solution->covariance[k] - of_poses.block<3, 3>(at, at)).norm(), 1e-10);
    if (k + 1 < kPoses)
    {
      EXPECT_LT((solution->with_successor[k] - of_poses.block<3, 3>(at, at + 3)).norm(), 1e-10);
    }
  }
}

TEST(PoseChainSystem, SaysWhenSomethingIsUndetermined)
{
  PoseChainSystem loose_pose(2, 0);
  loose_pose.addReading(0, 1, {1, 0, 0}, Eigen::RowVectorXd(0), 1);
  EXPECT_FALSE(loose_pose.solve());

  PoseChainSystem loose_error(1, 2);
  for (int axis = 0; axis < 3; ++axis)
    loose_error.addReading(0, 1, JacobianRow::Unit(axis), Eigen::RowVectorXd::Zero(2), 1);
  loose_error.addPrior(1, Eigen::RowVectorXd::Unit(2, 0), 1);
  EXPECT_FALSE(loose_error.solve());
  loose_error.addPrior(1, Eigen::RowVectorXd::Unit(2, 1), 1);
  EXPECT_TRUE(loose_error.solve());
}
}  // namespace mrpt_ext::test_block_tridiagonal_solver
