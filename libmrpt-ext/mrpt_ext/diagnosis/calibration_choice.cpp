#include "mrpt_ext/diagnosis/calibration_choice.h"

#include <algorithm>

#include "mrpt_ext/diagnosis/choice_part.h"
#include "mrpt_ext/diagnosis/configured_model.h"
#include "mrpt_ext/diagnosis/noise_candidates.h"
#include "mrpt_ext/diagnosis/partial_calibration.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPays = 2;           // standard deviations, of an error and of a gain
constexpr double kSurveyed = 3;       // standard deviations of a gain, of errors of the map
constexpr double kBeyondDoubt = 4;    // standard deviations, of an error
constexpr double kHarms = -1;         // standard deviations of a gain
constexpr double kLeastShare = 1e-3;  // of outliers

class ChoiceSearch
{
 public:
  ChoiceSearch(const CalibrationData& data, const std::vector<CalibrationUnknown>& unknowns,
               const LocalizationConfig& config)
      : data_(data),
        unknowns_(unknowns),
        config_(config),
        middle_(middleOf(data.problem)),
        before_(firstPart(data.problem, middle_)),
        noise_(data, config, first_half_, middle_)
  {
    first_half_ = calibrate(before_, unknowns);
    if (first_half_.status == SolveStatus::ok) addParts(withToldRegimes(unknowns, first_half_, kPays));
  }

  [[nodiscard]] CalibrationChoice run()
  {
    const std::vector<double> configured = densitiesOf({}, first_half_);
    std::vector<double> best = densitiesOf(parts_, found_);
    dropErrorsOfMap(best);
    together_ = payTogether(best);
    while (const std::optional<std::size_t> worst = worstPart(best))
    {
      takeOut(*worst);
      best = densitiesOf(parts_, found_);
    }
    CalibrationChoice chosen = choice(configured, best);
    if (chosen.calibrated > chosen.configured) return chosen;
    parts_.clear();
    return choice(configured, configured);
  }

 private:
  /// `numbers`: of the unknowns that come into question.
  void addParts(const std::vector<std::size_t>& numbers)
  {
    if (numbers.size() < unknowns_.size()) first_half_ = calibrateSome(before_, unknowns_, numbers, first_half_);
    addErrors(numbers);
    dropUntold();
    for (std::size_t s = 0; s < data_.sensors.size(); ++s)
    {
      if (noise_.isOther(s, false)) parts_.push_back({PartKind::bearing_noise, {}, s});
      if (noise_.isOther(s, true)) parts_.push_back({PartKind::range_noise, {}, s});
      if (noise_.moreOutliers(s) > 0) parts_.push_back({PartKind::outliers, {}, s});
    }
    for (const MotionNoise noise : {position_noise, heading_noise})
      if (noise_.isOther(noise)) parts_.push_back({PartKind::odometry_noise, {}, 0, noise});
  }

  void addErrors(const std::vector<std::size_t>& numbers)
  {
    for (const std::size_t k : numbers)
    {
      const ParameterEstimate& error = first_half_.errors[k];
      if (!error.observable && !isOfRadios(unknowns_[k])) continue;
      const auto partner = std::find_if(
          parts_.begin(), parts_.end(),
          [&](const ChoicePart& part)
          { return part.kind == PartKind::errors && belongTogether(unknowns_[part.errors.front()], unknowns_[k]); });
      if (partner != parts_.end())
        partner->errors.push_back(k);
      else
        parts_.push_back({PartKind::errors, {k}, unknowns_[k].sensor});
    }
  }

  /// Takes out, one by one, what the first half does not tell beside the others.
  void dropUntold()
  {
    found_ = fitOf(parts_);
    while (const std::optional<std::size_t> weakest = weakestPart())
    {
      parts_ = allBut(*weakest);
      found_ = fitOf(parts_);
    }
  }

  /// How strongly the first half tells a part beside the others. Errors of ranges also with the sensor where it is
  /// stated: of its place and these it may tell the sum alone, which displaces the robot all the same.
  [[nodiscard]] double strengthBeside(const ChoicePart& part) const
  {
    const double strength = strengthOf(part, found_);
    if (strength > kPays || part.errors.empty() || !isRangeError(unknowns_[part.errors.front()])) return strength;
    std::vector<std::size_t> numbers = besides(parts_);
    std::erase_if(numbers, [this](std::size_t k) { return isPlaceError(unknowns_[k]); });
    return std::max(strength, strengthOf(part, fitOf(parts_, std::move(numbers))));
  }

  /// The part that the first half tells least of, if that is nothing. Offset and scale of radios, which it may not tell
  /// from each other, are tried one by one later.
  [[nodiscard]] std::optional<std::size_t> weakestPart() const
  {
    std::optional<std::size_t> weakest;
    double least = kPays;
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
      if (isOfLandmarks(parts_[k]) || isPair(parts_[k])) continue;
      const double strength = strengthBeside(parts_[k]);
      if (strength > least) continue;
      least = strength;
      weakest = k;
    }
    return weakest;
  }

  /// Takes out all errors of the map at once where together they do not pay; `best`: densities with what stays. Places
  /// of good surveys, which are most, are not looked at one by one.
  void dropErrorsOfMap(std::vector<double>& best)
  {
    std::vector<ChoicePart> others = parts_;
    std::erase_if(others, [this](const ChoicePart& part) { return isOfMap(part); });
    if (others.size() == parts_.size()) return;
    CalibrationResult found = fitOf(others);
    std::vector<double> without = densitiesOf(others, found);
    const PredictiveGain gain = predictiveGain(data_.problem, middle_, best, without);
    if (gain.gain > kPays * gain.std) return;
    parts_ = std::move(others);
    found_ = std::move(found);
    best = std::move(without);
  }

  /// True for errors of a sensor or of odometry that no landmark has by itself, but for the pair of radios.
  [[nodiscard]] bool isSystematic(const ChoicePart& part) const
  {
    return part.kind == PartKind::errors && !isOfLandmarks(part) && !isOfRadios(unknowns_[part.errors.front()]);
  }

  /// True when the second half is predicted better with all systematic errors than without any. One of them then stays
  /// unless it harms: those that are much alike (a scale, an offset, an axis) take each other's part when one is left
  /// out, so that none of them seems to pay. Not so those that have to pay alone.
  [[nodiscard]] bool payTogether(const std::vector<double>& best) const
  {
    std::vector<ChoicePart> others = parts_;
    std::erase_if(others, [this](const ChoicePart& part) { return isSystematic(part); });
    if (others.size() == parts_.size()) return false;
    double needed = kPays;
    for (const ChoicePart& part : parts_)
      if (isSystematic(part)) needed = std::min(needed, neededGain(part));
    const PredictiveGain gain = predictiveGain(data_.problem, middle_, best, densitiesOf(others, fitOf(others)));
    return gain.gain > needed * gain.std;
  }

  /// The part that the second half is predicted best without, if it does not pay.
  [[nodiscard]] std::optional<std::size_t> worstPart(const std::vector<double>& best) const
  {
    std::optional<std::size_t> worst;
    double least = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
      const std::vector<double> without = densitiesOf(allBut(k), foundWithout(k));
      const PredictiveGain gain = predictiveGain(data_.problem, middle_, best, without);
      // Without effect on the second half nothing speaks for it.
      const double margin = gain.std > 0 ? gain.gain / gain.std - neededGain(parts_[k]) : -kPays;
      if (margin > least) continue;
      least = margin;
      worst = k;
    }
    return worst;
  }

  /// Deviations of odometry over the configured ones that come with the noise of a sensor.
  [[nodiscard]] PerMotionNoise<double> odometryBeside(const ChoicePart& part, const CalibrationResult& found) const
  {
    const SensorScatter& sensor = found.scatter[part.sensor];
    const double scatter = part.kind == PartKind::bearing_noise ? sensor.bearing
                           : part.kind == PartKind::range_noise ? sensor.range
                                                                : 1;
    return noise_.odometryBeside(scatter, found);
  }

  [[nodiscard]] static double strengthOf(const ChoicePart& part, const CalibrationResult& found)
  {
    double strength = 0;
    for (const std::size_t k : part.errors) strength = std::max(strength, mrpt_ext::strengthOf(found.errors[k]));
    return strength;
  }

  /// Standard deviations of the gain: from two, for what the first half tells by two of its own, to none at four; below
  /// none where systematic errors pay together.
  [[nodiscard]] double neededGain(const ChoicePart& part) const
  {
    if (isOfMap(part)) return kSurveyed;
    if (together_ && isSystematic(part) && !paysAlone(unknowns_[part.errors.front()])) return kHarms;
    return isOfLandmarks(part) ? kPays : std::clamp(kBeyondDoubt - strengthOf(part, found_), 0.0, kPays);
  }

  [[nodiscard]] bool isOfMap(const ChoicePart& part) const
  {
    return !part.errors.empty() && mrpt_ext::isOfMap(unknowns_[part.errors.front()].parameter);
  }

  [[nodiscard]] bool isOfLandmarks(const ChoicePart& part) const
  {
    return !part.errors.empty() && isOfLandmark(unknowns_[part.errors.front()].parameter);
  }

  [[nodiscard]] static std::vector<std::size_t> errorsOf(const std::vector<ChoicePart>& parts)
  {
    std::vector<std::size_t> numbers;
    for (const ChoicePart& part : parts) numbers.insert(numbers.end(), part.errors.begin(), part.errors.end());
    return numbers;
  }

  [[nodiscard]] std::vector<std::size_t> besides(const std::vector<ChoicePart>& parts) const
  {
    return estimatedBeside(errorsOf(parts), unknowns_);
  }

  /// What the first half tells of the errors of `parts` where the others are as configured.
  [[nodiscard]] CalibrationResult fitOf(const std::vector<ChoicePart>& parts) const
  {
    return fitOf(parts, besides(parts));
  }

  /// The same beside the errors `numbers`.
  [[nodiscard]] CalibrationResult fitOf(const std::vector<ChoicePart>& parts, std::vector<std::size_t> numbers) const
  {
    const std::vector<std::size_t> errors = errorsOf(parts);
    numbers.insert(numbers.end(), errors.begin(), errors.end());
    return calibrateSome(before_, unknowns_, numbers, first_half_);
  }

  /// What was found, with the errors of a part as configured.
  [[nodiscard]] CalibrationResult foundWithout(std::size_t number) const
  {
    const std::vector<std::size_t>& errors = parts_[number].errors;
    const std::vector<std::size_t> kept = besides(allBut(number));
    const bool stay = !errors.empty() && std::find(kept.begin(), kept.end(), errors.front()) != kept.end();
    return stay ? found_ : withoutErrors(found_, errors);
  }

  /// Of offset and scale of radios the one stays that predicts the second half better, until it does not pay either.
  void takeOut(std::size_t number)
  {
    const ChoicePart part = parts_[number];
    parts_ = allBut(number);
    if (part.errors.empty()) return;
    if (!isPair(part))
    {
      found_ = fitOf(parts_);
      return;
    }
    const std::vector<ChoicePart> others = parts_;
    std::vector<double> best;
    for (const std::size_t error : part.errors)
    {
      std::vector<ChoicePart> with = others;
      with.push_back({PartKind::errors, {error}, part.sensor});
      CalibrationResult found = fitOf(with);
      std::vector<double> densities = densitiesOf(with, found);
      if (!best.empty() && predictiveGain(data_.problem, middle_, densities, best).gain <= 0) continue;
      best = std::move(densities);
      parts_ = std::move(with);
      found_ = std::move(found);
    }
  }

  /// True for what the ranges of a sensor share whose landmarks have offsets of their own.
  [[nodiscard]] bool isOfRadios(const CalibrationUnknown& unknown) const
  {
    return isOfAllRanges(unknown.parameter) &&
           std::any_of(unknowns_.begin(), unknowns_.end(),
                       [&](const CalibrationUnknown& other)
                       { return other.sensor == unknown.sensor && isLandmarkOffset(other); });
  }

  [[nodiscard]] bool isPair(const ChoicePart& part) const
  {
    return part.errors.size() == 2 && isOfRadios(unknowns_[part.errors.front()]);
  }

  [[nodiscard]] std::vector<ChoicePart> allBut(std::size_t number) const
  {
    std::vector<ChoicePart> rest = parts_;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(number));
    return rest;
  }

  [[nodiscard]] std::vector<double> densitiesOf(const std::vector<ChoicePart>& parts,
                                                const CalibrationResult& found) const
  {
    RecordingModel model = configuredModel(data_.sensors, unknowns_, config_);
    for (const ChoicePart& part : parts)
    {
      for (const std::size_t k : part.errors) model.errors[k].mean = found.errors[k].value;
      AssumedNoise& noise = model.sensors[part.sensor];
      const SensorScatter& scatter = found.scatter[part.sensor];
      if (part.kind == PartKind::bearing_noise) noise.bearing = scatter.bearing;
      if (part.kind == PartKind::range_noise) noise.range = scatter.range;
      if (part.kind == PartKind::outliers) noise.outliers = noise_.moreOutliers(part.sensor);
      if (part.kind == PartKind::odometry_noise) model.odometry[part.odometry] = found.odometry_scatter[part.odometry];
      const PerMotionNoise<double> beside = odometryBeside(part, found);
      for (const MotionNoise n : {position_noise, heading_noise})
        if (beside[n] < 1) model.odometry[n] = beside[n];
    }
    std::erase_if(model.errors, [](const AssumedError& error)
                  { return error.mean == 0 && error.std == 0 && error.std_per_sqrt_s == 0; });
    // Errors that are estimated on the way need the first half to settle.
    const bool settles =
        std::any_of(model.errors.begin(), model.errors.end(),
                    [](const AssumedError& error) { return error.std > 0 || error.std_per_sqrt_s > 0; });
    std::vector<double> densities = predictiveLogDensities(data_.problem, model, settles ? 0 : middle_);
    addUnmatched(model, densities);
    return densities;
  }

  /// A reading that no landmark is near is an outlier by every model: it counts at the last reading before it, without
  /// its density among outliers, which all models share.
  void addUnmatched(const RecordingModel& model, std::vector<double>& densities) const
  {
    const std::vector<CalibrationReading>& readings = data_.problem.readings;
    std::size_t next = 0;
    for (const UnmatchedReading& unmatched : data_.unmatched)
    {
      while (next < readings.size() && readings[next].pose <= unmatched.pose) ++next;
      if (next > 0) densities[next - 1] += std::log(std::max(model.sensors[unmatched.sensor].outliers, kLeastShare));
    }
  }

  [[nodiscard]] CalibrationChoice choice(const std::vector<double>& configured, const std::vector<double>& best) const
  {
    CalibrationChoice chosen;
    const std::size_t sensors = data_.sensors.size();
    chosen.noise = {.bearings = std::vector<bool>(sensors, false),
                    .ranges = std::vector<bool>(sensors, false),
                    .outliers = std::vector<bool>(sensors, false)};
    for (const ChoicePart& part : parts_)
    {
      for (const std::size_t k : part.errors) chosen.errors.push_back(unknowns_[k]);
      if (part.kind == PartKind::bearing_noise) chosen.noise.bearings[part.sensor] = true;
      if (part.kind == PartKind::range_noise) chosen.noise.ranges[part.sensor] = true;
      if (part.kind == PartKind::outliers) chosen.noise.outliers[part.sensor] = true;
      if (part.kind == PartKind::odometry_noise) chosen.noise.odometry[part.odometry] = true;
      const PerMotionNoise<double> beside = odometryBeside(part, found_);
      for (const MotionNoise n : {position_noise, heading_noise})
        chosen.noise.odometry[n] = chosen.noise.odometry[n] || beside[n] < 1;
    }
    for (const std::size_t k : besides(parts_)) chosen.beside.push_back(unknowns_[k]);
    double readings = 0;
    for (std::size_t i = 0; i < best.size(); ++i)
    {
      if (data_.problem.readings[i].pose < middle_) continue;
      ++readings;
      chosen.configured += (configured[i] - chosen.configured) / readings;
      chosen.calibrated += (best[i] - chosen.calibrated) / readings;
    }
    return chosen;
  }

  const CalibrationData& data_;
  const std::vector<CalibrationUnknown>& unknowns_;
  const LocalizationConfig& config_;
  std::size_t middle_;            // number of the first pose of the second half
  CalibrationProblem before_;     // the first half
  CalibrationResult first_half_;  // with all unknowns
  CalibrationResult found_;       // with those of the parts
  NoiseCandidates noise_;
  std::vector<ChoicePart> parts_;
  bool together_ = false;  // systematic errors pay together
};
}  // namespace

bool CalibrationChoice::empty() const
{
  const auto none = [](const std::vector<bool>& flags)
  { return std::find(flags.begin(), flags.end(), true) == flags.end(); };
  const auto& [position, heading] = noise.odometry;
  return errors.empty() && !position && !heading && none(noise.bearings) && none(noise.ranges) && none(noise.outliers);
}

CalibrationChoice chooseCalibration(const CalibrationData& data, const std::vector<CalibrationUnknown>& unknowns,
                                    const LocalizationConfig& config)
{
  if (data.problem.readings.empty()) return {};
  return ChoiceSearch(data, unknowns, config).run();
}
}  // namespace mrpt_ext
