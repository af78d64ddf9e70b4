#include "mrpt_ext/filter/integrity/filter_diagnostics.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/bias_units.h"
#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinDetections = 10;     // identified ones, to report a landmark at all
constexpr double kMaxOutlierShare = 0.3;  // of identified detections

/// Outliers among so many detections that kMaxOutlierShare explains: its mean and two standard deviations.
double maxPlausibleOutliers(double detections)
{
  return kMaxOutlierShare * detections + 2 * std::sqrt(kMaxOutlierShare * (1 - kMaxOutlierShare) * detections);
}

void append(std::string& text, const std::string& more)
{
  if (!text.empty()) text += ", ";
  text += more;
}
}  // namespace

std::vector<BiasEstimate> estimateBiases(const ParticleSet& particles)
{
  std::vector<BiasEstimate> estimates;
  for (const std::vector<float>& column : particles.bias)
  {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < column.size(); ++i)
    {
      const double w = std::exp(double{particles.log_weight[i]}), value = double{column[i]};
      sum += w * value;
      squares += w * value * value;
    }
    estimates.push_back({sum, std::sqrt(std::max(0.0, squares - sum * sum))});
  }
  return estimates;
}

std::string biasName(const BiasState& bias)
{
  const BiasUnit& unit = unitOf(bias.kind);
  return (bias.sensor.empty() ? "" : bias.sensor + ".") + unit.name + unit.suffix;
}

double fileUnit(const BiasState& bias) { return unitOf(bias.kind).factor; }

std::string biasText(const BiasModel& biases, const std::vector<BiasEstimate>& estimates)
{
  std::string text;
  for (std::size_t k = 0; k < std::min(biases.size(), estimates.size()); ++k)
  {
    const BiasUnit& unit = unitOf(biases[k].kind);
    append(text, (biases[k].sensor.empty() ? "" : biases[k].sensor + " ") +
                     formatted("%s %.4f%s%s (std %.4f)", unit.name, unit.factor * estimates[k].mean,
                               *unit.unit == '\0' ? "" : " ", unit.unit, unit.factor * estimates[k].std));
  }
  return text;
}

std::vector<std::size_t> outlierLandmarks(const std::vector<LandmarkHistory>& histories)
{
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < histories.size(); ++j)
    if (histories[j].identified >= kMinDetections &&
        histories[j].false_identified > maxPlausibleOutliers(histories[j].identified))
      found.push_back(j);
  return found;
}

std::string outlierText(const LandmarkTable& map, const std::vector<LandmarkHistory>& histories)
{
  constexpr std::size_t kNamed = 5;
  const std::vector<std::size_t> found = outlierLandmarks(histories);
  std::string text;
  for (std::size_t k = 0; k < std::min(found.size(), kNamed); ++k)
  {
    const LandmarkHistory& history = histories[found[k]];
    append(text, formatted("landmark %d: %.0f %% of %.0f detections are outliers", map[found[k]].id,
                           100 * history.false_identified / history.identified, history.identified));
  }
  if (found.size() > kNamed) append(text, formatted("and so for %zu more landmarks", found.size() - kNamed));
  return text;
}
}  // namespace mrpt_ext
