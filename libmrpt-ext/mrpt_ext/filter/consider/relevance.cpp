#include "mrpt_ext/filter/consider/relevance.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr Eigen::Index kAtATime = 2;  // parameters of an update
}  // namespace

std::vector<Eigen::Index> Relevance::relevant() const
{
  std::vector<Eigen::Index> indices;
  for (Eigen::Index k = 0; k < variances_.size(); ++k)
    if (variances_[k] > 0) indices.push_back(k);
  return indices;
}

void Relevance::update(const LinearEvidence& evidence, const PriorStds& prior)
{
  const Eigen::Index count = evidence.weighted.size();
  variances_.conservativeResizeLike(prior.least.cwiseAbs2());
  for (Eigen::Index n = 0; n < std::min(kAtATime, count); ++n)
  {
    const Eigen::Index k = next_++ % count;
    // What the others, as they are known, leave for this one.
    variances_[k] = 0;
    const RelevantParameters others = posterior(evidence);
    const auto shared = evidence.information.col(k);
    const double information = evidence.information(k, k) - shared.dot(others.covariance * shared);
    const double weighted = evidence.weighted[k] - shared.dot(others.mean);
    double seems = information > 0 ? square(weighted / information) : 0;
    if (prior.least[k] > 0 && information > 0) seems -= 1 / information;
    variances_[k] = std::clamp(seems, square(prior.least[k]), square(prior.most[k]));
  }
}

RelevantParameters Relevance::posterior(const LinearEvidence& evidence) const
{
  const Eigen::Index count = evidence.weighted.size();
  RelevantParameters all{Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(count, count)};
  const std::vector<Eigen::Index> indices = relevant();
  if (indices.empty()) return all;
  Eigen::MatrixXd information = evidence.information(indices, indices);
  const Eigen::VectorXd of_prior = variances_(indices).cwiseInverse();
  information.diagonal() += of_prior;
  const Eigen::MatrixXd covariance =
      information.llt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  all.covariance(indices, indices) = covariance;
  all.mean = all.covariance * evidence.weighted;
  return all;
}

LinearEvidence Relevance::marginal(const LinearEvidence& evidence, const std::vector<Eigen::Index>& parameters) const
{
  LinearEvidence alone{evidence.information(parameters, parameters), evidence.weighted(parameters)};
  std::vector<Eigen::Index> others = relevant();
  std::erase_if(others,
                [&](Eigen::Index k) { return std::find(parameters.begin(), parameters.end(), k) != parameters.end(); });
  if (others.empty()) return alone;
  Eigen::MatrixXd information = evidence.information(others, others);
  information.diagonal() += Eigen::VectorXd(variances_(others).cwiseInverse());
  const Eigen::MatrixXd shared = evidence.information(others, parameters);
  const Eigen::LLT<Eigen::MatrixXd> solver(information);
  alone.information -= shared.transpose() * solver.solve(shared);
  alone.weighted -= shared.transpose() * solver.solve(Eigen::VectorXd(evidence.weighted(others)));
  return alone;
}
}  // namespace mrpt_ext
