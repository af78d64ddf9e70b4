#include "mrpt_ext/filter/consider/score_variance.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr double kBlock = 10;  // [s], about as long as a landmark stays in view
}  // namespace

void ScoreVariance::add(double duration, const Eigen::VectorXd& score, const Eigen::VectorXd& information, double kept)
{
  for (Eigen::VectorXd* sum : {&score_, &information_, &squared_, &expected_})
    sum->conservativeResizeLike(Eigen::VectorXd::Zero(score.size()));
  score_ += score;
  information_ += information;
  squared_ *= kept;
  expected_ *= kept;
  duration_ += std::max(0.0, duration);
  if (duration_ < kBlock) return;
  squared_ += score_.cwiseAbs2();
  expected_ += information_;
  score_.setZero();
  information_.setZero();
  duration_ = 0;
}

Eigen::VectorXd ScoreVariance::worth(Eigen::Index size) const
{
  Eigen::VectorXd worth = Eigen::VectorXd::Ones(size);
  for (Eigen::Index k = 0; k < std::min(size, squared_.size()); ++k)
    if (squared_[k] > expected_[k]) worth[k] = expected_[k] / squared_[k];
  return worth;
}
}  // namespace mrpt_ext
