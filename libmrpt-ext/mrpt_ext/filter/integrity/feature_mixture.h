#pragma once

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
/// What the tracked features of a null model expect of one detection.
struct FeatureDensities
{
  bool any = false;    ///< there are features to compare with
  double in_view = 0;  ///< their expected number
  double rates = 0;    ///< sum of the rates of those in view: their chances to be seen, relative to each other
  double sum = 0;      ///< of their densities of the detection, each times its rate
};

/// A detection comes from one of the features in view, each with a chance in proportion to its rate, from a new one or
/// from clutter. New ones are expected with their frequency among those counted (Laplace's rule of succession). Which
/// detections were new is not known: each counts with its probability (quasi-Bayes estimate of mixture weights; Smith,
/// Makov, J. Roy. Stat. Soc. B 40, 1978). Counted by the likelier case instead, a run of new ones would make all later
/// ones seem new as well.
class FeatureMixture
{
 public:
  struct Outcome
  {
    double log_density = 0;
    double share_new = 1;   ///< probability of a new feature, before the detection was seen
    double share_each = 0;  ///< ... of one of those in view, on average
    double new_given_detection = 1;

    /// Rather one of the features than a new one.
    [[nodiscard]] bool isKnown() const { return new_given_detection < 0.5; }
  };

  /// `uniform`: the density of new features and of clutter.
  [[nodiscard]] Outcome expect(const FeatureDensities& known, double uniform, double clutter) const
  {
    const double p_new = known.any ? (new_ + 1) / (count_ + 2) : 1;
    const double mean_rate = known.in_view > 0 ? known.rates / known.in_view : 1;
    const double p_each = (1 - p_new) / std::max(1.0, known.in_view);
    const double of_new = p_new * uniform, of_known = p_each * known.sum / mean_rate;
    const double density = clutter * uniform + (1 - clutter) * (of_new + of_known);
    return {std::log(density), p_new, p_each, of_new + of_known > 0 ? of_new / (of_new + of_known) : 1};
  }
  /// Whether a detection rather shows one of the features in view than something else, both as likely beforehand: by a
  /// mixture that has counted nothing.
  [[nodiscard]] static bool recognizes(const FeatureDensities& known, double uniform, double clutter)
  {
    return FeatureMixture().expect(known, uniform, clutter).isKnown();
  }
  /// Counts a detection that was expected so.
  void count(const Outcome& expected)
  {
    count_ += 1;
    new_ += expected.new_given_detection;
  }

 private:
  double count_ = 0, new_ = 0;  // so far, expected
};
}  // namespace mrpt_ext
